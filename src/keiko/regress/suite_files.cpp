#include "keiko/regress/suite_files.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/base/output_target.h"
#include "keiko/base/sha256.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/fixture_file.h"
#include "keiko/regress/run_fixture.h"

#include <algorithm>
#include <chrono>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// Time that the other copy of a task may take to write what this one writes too.
constexpr std::chrono::minutes write_patience{1};

/// Candidate that an earlier run has finished; nullopt where there is none, or one of other inputs,
/// or a damaged one.
std::optional<FixtureRecord> finished_candidate(const fs::path& folder, const std::string& key) {
    try {
        const FolderContent files = read_folder(folder);
        if (files.empty()) return std::nullopt;
        KeptRecord kept = record_of(files, folder.string());
        if (kept.key == key) return std::move(kept.record);
    } catch (const Error&) {
    }
    return std::nullopt;
}

/// Setup of the baseline; an empty one where there is no baseline, or a damaged one, which the
/// outcome reports.
FixtureSetup kept_setup(const RegressOptions& options, const std::string& name) {
    try {
        if (auto baseline = locked_baseline(options, name))
            return std::move(baseline->record.setup);
    } catch (const Error&) {
    }
    return {};
}

void write_pictures(const fs::path& folder, const FolderContent& pngs) {
    const FolderLock lock(folder.parent_path(), write_patience);
    std::error_code ignored; // an older picture that stays is named by no report
    if (pngs.empty())
        fs::remove_all(folder, ignored);
    else
        write_folder_atomically(folder, pngs);
}

} // namespace

std::vector<std::string> names_of(std::span<const FixtureFile> fixtures) {
    std::vector<std::string> names;
    for (const FixtureFile& fixture : fixtures) names.push_back(fixture.name);
    return names;
}

std::vector<FixtureFile> chosen(std::vector<FixtureFile> fixtures,
                                std::span<const std::string> names) {
    const std::vector<std::string> known = names_of(fixtures);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw Error("", "",
                        "no fixture is called '" + shortened(name) + "'" +
                            did_you_mean(name, known) + "; there are " + comma_list(known));
    std::erase_if(fixtures, [&](const FixtureFile& fixture) {
        return std::find(names.begin(), names.end(), fixture.name) == names.end();
    });
    return fixtures;
}

FixtureRecord candidate_of(const FixtureSpec& spec, const RegressOptions& options, const Job& job) {
    const fs::path folder = options.output / spec.name / "candidate";
    const FixtureSetup setup = kept_setup(options, spec.name);
    const std::string key = fixture_key(spec.file, setup, options.load);
    if (!options.fresh)
        if (auto finished = finished_candidate(folder, key)) return std::move(*finished);
    // The key is of the files as they are now, the spec of the fixture as it was read.
    KeptRecord kept{run_fixture(read_fixture(spec.file), setup, options.load, job), key, {}};
    if (fixture_key(spec.file, setup, options.load) != key)
        throw Error(spec.file.string(), "", "its files were changed while it ran; run it again");
    const FolderLock lock(folder.parent_path(), write_patience);
    write_folder_atomically(folder, files_of(kept));
    return std::move(kept.record);
}

fs::path baseline_folder(const RegressOptions& options) {
    return options.baselines.empty() ? options.suite / "baselines" : options.baselines;
}

std::optional<KeptRecord> kept_baseline(const fs::path& folder) {
    const FolderContent files = read_folder(folder);
    if (files.empty()) return std::nullopt;
    return record_of(files, folder.string());
}

std::optional<KeptRecord> locked_baseline(const RegressOptions& options, const std::string& name) {
    const FolderReadLock lock(baseline_folder(options));
    return kept_baseline(baseline_folder(options) / name);
}

namespace {

std::string outcome_key(const FixtureFile& fixture, const RegressOptions& options) {
    std::string text = fixture.name + " ";
    try {
        text += fixture_key(fixture.file, {}, options.load);
    } catch (const Error& error) { // it will be the fixture's outcome
        text += error.what();
    }
    for (const auto& [name, bytes] : read_folder(baseline_folder(options) / fixture.name))
        text += " " + name + " " + sha256_hex(bytes);
    return sha256_hex(text);
}

} // namespace

std::vector<std::string> outcome_keys(std::span<const FixtureFile> suite,
                                      const RegressOptions& options) {
    std::vector<std::string> keys;
    for (const FixtureFile& fixture : suite) keys.push_back(outcome_key(fixture, options));
    return keys;
}

std::string suite_key(std::span<const std::string> outcome_keys) {
    std::string text;
    for (const std::string& key : outcome_keys) text += key + "\n";
    return sha256_hex(text);
}

std::vector<std::string> stale_baselines(std::span<const FixtureFile> suite,
                                         const RegressOptions& options) {
    const std::vector<std::string> known = names_of(suite);
    std::vector<std::string> stale;
    std::error_code ignored; // there need not be any baselines
    for (const fs::directory_entry& entry :
         fs::directory_iterator(baseline_folder(options), ignored)) {
        const std::string name = entry.path().filename().string();
        const bool known_name = std::find(known.begin(), known.end(), name) != known.end();
        if (entry.is_directory(ignored) && !name.starts_with(".") && !known_name)
            stale.push_back(name);
    }
    std::sort(stale.begin(), stale.end());
    return stale;
}

void require_apart(const RegressOptions& options, std::span<const FixtureFile> fixtures) {
    const fs::path baselines = baseline_folder(options);
    const fs::path& output = options.output;
    if (lies_within(output, baselines))
        throw Error(output.string(), "",
                    "is in the folder of the baselines, " + baselines.string() +
                        ", which a run only reads; name another folder for its reports");
    for (const FixtureFile& fixture : fixtures)
        if (lies_within(baselines, output / fixture.name))
            throw Error(output.string(), "",
                        "would hold the reports of fixture '" + shortened(fixture.name) +
                            "' where the baselines are, " + baselines.string() +
                            "; name another folder");
}

void write_reports(const fs::path& output, const Regression& regression) {
    for (const FixtureOutcome& fixture : regression.fixtures)
        write_pictures(output / fixture.name / "pictures", fixture.pngs);
    FileTransaction reports;
    reports.add(output / "junit.xml", regression_junit(regression));
    reports.add(output / "index.html", regression_html(regression));
    reports.add(output / regression_file, regression_json(regression));
    reports.write();
}

Regression read_reports(const fs::path& output) {
    const fs::path file = output / regression_file;
    Regression regression = parse_regression(read_file(file), file.string());
    for (FixtureOutcome& fixture : regression.fixtures)
        fixture.pngs = read_folder(output / fixture.name / "pictures");
    return regression;
}

} // namespace keiko
