#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/fixture_file.h"
#include "keiko/regress/suite_files.h"
#include "keiko/workflow/version.h"

#include <array>
#include <ctime>

namespace keiko {
namespace fs = std::filesystem;
namespace {

std::string time_now() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

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
        accepted.push_back(accept(fixtures[i], candidates[i], baselines / fixtures[i].name,
                                  {time_now(), by, reason, "keiko " + version(), {}}));
    return accepted;
}

} // namespace keiko
