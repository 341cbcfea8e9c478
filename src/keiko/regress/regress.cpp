#include "keiko/regress/regress.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/fixture_file.h"
#include "keiko/regress/suite_files.h"
#include "keiko/workflow/draw_outcome.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <map>

namespace keiko {
namespace {

const Film* film_in(const FixturePicture* picture) {
    return picture ? &picture->film : nullptr;
}

PictureOutcome picture_outcome(const PictureDifference& difference) {
    PictureOutcome picture{.view = difference.view, .problem = difference.problem};
    if (!difference.film) return picture;
    picture.take(*difference.film);
    return picture;
}

/// The checks that the fixture asks for, and those whose numbers are gone from it.
std::vector<std::string> checks_of(const FixtureSpec& spec, const FixtureDifference& difference) {
    std::vector<std::string> checks;
    if (spec.checks.shape) checks.emplace_back("shape");
    if (spec.checks.seams) checks.emplace_back("seams");
    if (spec.checks.lines) checks.emplace_back("lines");
    for (const MetricDifference& metric : difference.metrics)
        if (std::find(checks.begin(), checks.end(), metric.check) == checks.end())
            checks.push_back(metric.check);
    return checks;
}

/// Outcome of a fixture whose record is held against its baseline, with pictures of what differs,
/// or of all views where there is no baseline.
FixtureOutcome fixture_outcome(const FixtureSpec& spec, const FixtureRecord* baseline,
                               const FixtureRecord& candidate) {
    FixtureOutcome outcome{.name = spec.name};
    if (!baseline) {
        outcome.state = FixtureState::missing;
        for (const FixturePicture& view : candidate.pictures) {
            outcome.pictures.push_back({.view = view.view});
            draw_outcome(outcome.pictures.back(), nullptr, &view.film, nullptr, outcome.pngs);
        }
        return outcome;
    }
    FixtureDifference difference = fixture_difference(*baseline, candidate, spec);
    if (!difference.within()) outcome.state = FixtureState::different;
    outcome.checks = checks_of(spec, difference);
    outcome.metrics_compared = difference.metrics_compared;
    outcome.metrics = std::move(difference.metrics);
    for (const PictureDifference& view : difference.pictures) {
        outcome.pictures.push_back(picture_outcome(view));
        if (!view.within())
            draw_outcome(outcome.pictures.back(), film_in(baseline->picture(view.view)),
                         film_in(candidate.picture(view.view)),
                         view.film ? &view.film->excess : nullptr, outcome.pngs);
    }
    return outcome;
}

std::vector<FixtureFile> share_of(const std::vector<FixtureFile>& fixtures, const Shard& shard) {
    std::vector<FixtureFile> share;
    for (std::size_t i = 0; i < fixtures.size(); ++i)
        if (i % static_cast<std::size_t>(shard.count) + 1 == static_cast<std::size_t>(shard.number))
            share.push_back(fixtures[i]);
    return share;
}

FixtureOutcome run_one(const FixtureFile& fixture, const RegressOptions& options, const Job& job) {
    try {
        const FixtureSpec spec = read_fixture(fixture.file);
        const FixtureRecord candidate = candidate_of(spec, options, job);
        const std::optional<KeptRecord> baseline = locked_baseline(options, spec.name);
        return fixture_outcome(spec, baseline ? &baseline->record : nullptr, candidate);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        return {.name = fixture.name, .state = FixtureState::error, .error = error.what()};
    }
}

} // namespace

Regression run_regression(const RegressOptions& options, const Job& job) {
    require_apart(options, {});
    withdraw_reports(options.output);
    const std::vector<FixtureFile> all = fixture_files(options.suite);
    require_apart(options, all);
    const std::vector<FixtureFile> suite = options.only.empty() ? all : chosen(all, options.only);
    const std::vector<FixtureFile> share = share_of(suite, options.shard);
    const FolderLock lock(options.output);
    Regression regression{.tool_version = version(),
                          .suite = names_of(suite),
                          .suite_key = suite_key(suite, options),
                          .stale_baselines = stale_baselines(all, options),
                          .shard = options.shard.number,
                          .shards = options.shard.count};
    for (std::size_t i = 0; i < share.size(); ++i) {
        job.check();
        regression.fixtures.push_back(
            run_one(share[i], options, job_of_fixture(job, i, share.size(), share[i].name)));
    }
    write_reports(options.output, regression);
    return regression;
}

namespace fs = std::filesystem;
namespace {

/// Throws Error where two shards differ in what all shards of a run have in common.
void require_same_suite(const Regression& one, const Regression& first, const fs::path& folder) {
    const auto fail = [&](const char* what) {
        throw Error(folder.string(), "", std::string("is a shard of another run: ") + what);
    };
    if (one.suite != first.suite) fail("its suite has other fixtures");
    if (one.shards != first.shards) fail("it is divided in another number of shards");
    if (one.suite_key != first.suite_key)
        fail("files, baselines or the program were others when it ran");
    if (one.tool_version != first.tool_version) fail("it is of another version of Keiko");
}

/// The shards by number. Throws Error where they are not all of one run, each once.
std::map<int, Regression> read_shards(std::span<const fs::path> folders) {
    std::map<int, Regression> shards;
    std::map<int, fs::path> places;
    for (const fs::path& folder : folders) {
        Regression shard = read_reports(folder);
        const int number = shard.shard;
        if (!shards.empty()) require_same_suite(shard, shards.begin()->second, folder);
        if (const auto [at, added] = places.emplace(number, folder); !added)
            throw Error(folder.string(), "",
                        "is shard " + std::to_string(number) + ", as is " + at->second.string());
        shards.emplace(number, std::move(shard));
    }
    return shards;
}

void require_every_shard(const std::map<int, Regression>& shards) {
    const int count = shards.begin()->second.shards;
    for (int number = 1; number <= count; ++number)
        if (!shards.contains(number))
            throw Error(
                "", "",
                "shard " + std::to_string(number) + " of " + std::to_string(count) + " is missing");
}

/// The run that was divided.
Regression joined(std::map<int, Regression> shards) {
    std::map<std::string, FixtureOutcome> outcomes;
    for (auto& [number, shard] : shards)
        for (FixtureOutcome& fixture : shard.fixtures)
            outcomes.emplace(fixture.name, std::move(fixture));
    Regression merged = std::move(shards.begin()->second);
    merged.shard = merged.shards = 1;
    merged.fixtures.clear();
    for (auto& [name, outcome] : outcomes) merged.fixtures.push_back(std::move(outcome));
    return merged;
}

} // namespace

Regression merge_regressions(std::span<const fs::path> folders, const fs::path& output) {
    for (const fs::path& folder : folders)
        if (fs::exists(output) && fs::equivalent(folder, output))
            throw FieldError("output", output.string() + " is a shard itself");
    withdraw_reports(output);
    std::map<int, Regression> shards = read_shards(folders);
    require_every_shard(shards);
    Regression merged = joined(std::move(shards));
    const FolderLock lock(output);
    write_reports(output, merged);
    return merged;
}

namespace fs = std::filesystem;
namespace {

std::string picture_change(const PictureDifference& picture) {
    if (!picture.film) return picture.view + ": " + picture.problem;
    std::string text = picture.view + ": ";
    for (const LayerDifference& layer : picture.film->layers)
        if (!layer.within)
            text +=
                layer.layer + " beyond its tolerance in " + counted(layer.beyond, "pixel") + "; ";
    return text + counted(picture.film->coverage_flips + picture.film->face_flips, "pixel") +
           " of the silhouette";
}

/// Changes that a new baseline makes, one line each.
std::vector<std::string> changes_between(const FixtureSpec& spec, const FixtureRecord& before,
                                         const FixtureRecord& after) {
    const FixtureDifference difference = fixture_difference(before, after, spec);
    std::vector<std::string> lines;
    for (const MetricDifference& metric : difference.metrics) lines.push_back(text_of(metric));
    for (const PictureDifference& picture : difference.pictures)
        if (!picture.within()) lines.push_back(picture_change(picture));
    if (lines.empty()) lines.emplace_back("differences within the tolerances");
    return lines;
}

FolderContent content_files(const FixtureRecord& record) {
    return files_of({record, "", {}});
}

AcceptedBaseline accept(const FixtureSpec& spec, const FixtureRecord& candidate,
                        const fs::path& folder, BaselineChange change) {
    KeptRecord kept{candidate, "", {}};
    try {
        if (const std::optional<KeptRecord> old = kept_baseline(folder)) {
            kept.changes = old->changes;
            if (content_files(old->record) == content_files(candidate)) return {spec.name, {}};
            change.changed = changes_between(spec, old->record, candidate);
        } else {
            change.changed = {"first baseline: " + counted(candidate.metrics.size(), "metric") +
                              ", " + counted(candidate.pictures.size(), "view")};
        }
    } catch (const Error& error) {
        kept.changes = changes_in(read_folder(folder));
        change.changed = {std::string("replaces a baseline that was damaged: ") + error.what()};
    }
    kept.changes.push_back(change);
    write_folder_atomically(folder, files_of(kept));
    return {spec.name, std::move(change)};
}

} // namespace

std::vector<AcceptedBaseline> update_baselines(const RegressOptions& options,
                                               std::span<const std::string> names,
                                               const std::string& by, const std::string& reason,
                                               const Job& job) {
    const std::vector<FixtureFile> suite = fixture_files(options.suite);
    require_apart(options, suite);
    std::vector<FixtureSpec> fixtures;
    for (const FixtureFile& fixture : chosen(suite, names))
        fixtures.push_back(read_fixture(fixture.file));
    const FolderLock output_lock(options.output);
    std::vector<FixtureRecord> candidates;
    for (std::size_t i = 0; i < fixtures.size(); ++i)
        candidates.push_back(candidate_of(
            fixtures[i], options, job_of_fixture(job, i, fixtures.size(), fixtures[i].name)));
    const fs::path baselines = baseline_folder(options);
    const FolderLock baselines_lock(baselines);
    std::vector<AcceptedBaseline> accepted;
    for (std::size_t i = 0; i < fixtures.size(); ++i)
        accepted.push_back(
            accept(fixtures[i], candidates[i], baselines / fixtures[i].name,
                   {utc_now("%Y-%m-%dT%H:%M:%SZ"), by, reason, "keiko " + version(), {}}));
    return accepted;
}

} // namespace keiko
