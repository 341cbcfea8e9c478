#include "keiko/regress/regress.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/fixture_file.h"
#include "keiko/regress/fixture_outcome.h"
#include "keiko/regress/suite_files.h"
#include "keiko/workflow/version.h"

namespace keiko {
namespace {

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

} // namespace keiko
