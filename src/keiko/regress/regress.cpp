#include "keiko/regress/regress.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/batch/whole_run.h"
#include "keiko/files/scene/fixture_file.h"
#include "keiko/regress/suite_files.h"
#include "keiko/regress/suite_shards.h"
#include "keiko/workflow/draw_outcome.h"
#include "keiko/workflow/version.h"

#include <algorithm>

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

/// The fixtures of the suite. An error removes the reports of an earlier run.
std::vector<FixtureFile> readable_suite(const RegressOptions& options) {
    try {
        return fixture_files(options.suite);
    } catch (const Error&) {
        withdraw_reports(options.output, regression_file);
        throw;
    }
}

void run_fixtures(std::span<const FixtureFile> fixtures, const RegressOptions& options,
                  Regression& regression, const Job& job) {
    for (std::size_t i = 0; i < fixtures.size(); ++i) {
        job.check();
        regression.fixtures.push_back(
            run_one(fixtures[i], options, job_of_part(job, i, fixtures.size(), fixtures[i].name)));
    }
}

/// A run whose fixtures did not run yet.
Regression empty_regression(std::span<const FixtureFile> all, std::span<const FixtureFile> suite,
                            std::span<const std::string> keys, const RegressOptions& options) {
    const Shard shard = options.shard.value_or(Shard());
    return {.tool_version = version(),
            .suite = names_of(suite),
            .suite_key = suite_key(keys),
            .stale_baselines = stale_baselines(all, options),
            .shard = shard.number,
            .shards = shard.count};
}

/// Runs a whole suite, alone in its output folder.
void run_suite(std::span<const FixtureFile> suite, const RegressOptions& options,
               Regression& regression, const Job& job) {
    const FolderLock lock(options.output);
    run_fixtures(suite, options, regression, job);
    write_reports(options.output, regression);
}

/// Runs a shard in its folder of the run's `output`. There is no lock on it: a task that its
/// scheduler started anew meets its old copy, and what both write is whole and the same.
void run_shard(std::span<const FixtureFile> suite, const ShardPlan& plan,
               const std::filesystem::path& output, const RegressOptions& options,
               Regression& regression, const Job& job) {
    claim_shard(output, plan, options.shard->number);
    withdraw_reports(options.output, regression_file);
    run_fixtures(share_of(suite, plan, options.shard->number), options, regression, job);
    require_claimed(output, plan);
    write_reports(options.output, regression);
}

} // namespace

Regression run_regression(const RegressOptions& given, const Job& job) {
    RegressOptions options = given;
    if (given.shard) options.output = shard_folder(given.output, given.shard->number);
    require_apart(options, {});
    if (!given.shard) withdraw_reports(options.output, regression_file);
    const std::vector<FixtureFile> all = readable_suite(options);
    require_apart(options, all);
    const std::vector<FixtureFile> suite = options.only.empty() ? all : chosen(all, options.only);
    const std::vector<std::string> keys = outcome_keys(suite, options);
    Regression regression = empty_regression(all, suite, keys, options);
    if (given.shard)
        run_shard(suite, suite_plan(suite, keys, regression.suite_key, given.shard->count),
                  given.output, options, regression, job);
    else
        run_suite(suite, options, regression, job);
    return regression;
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
        candidates.push_back(candidate_of(fixtures[i], options,
                                          job_of_part(job, i, fixtures.size(), fixtures[i].name)));
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
