#include "keiko/regress/suite_shards.h"

#include "keiko/base/error.h"
#include "keiko/batch/balanced_shards.h"
#include "keiko/files/toml/toml_document.h"

#include <algorithm>

namespace keiko {
namespace {

double fixture_cost(const FixtureFile& fixture) {
    try {
        const FixtureSpec spec = read_fixture(fixture.file);
        const std::size_t views =
            spec.checks.pictures ? std::max<std::size_t>(spec.views.size(), 1) : 0;
        return body_cost(files_named_by(fixture.file)) +
               pictures_cost(views, spec.width, spec.height);
    } catch (const Error&) { // its outcome, which costs next to nothing
        return body_cost({});
    }
}

} // namespace

ShardPlan suite_plan(std::span<const FixtureFile> suite, std::span<const std::string> keys,
                     const std::string& key, int shards) {
    std::vector<PlannedPart> parts;
    std::vector<double> costs;
    for (std::size_t i = 0; i < suite.size(); ++i) {
        if (is_shard_name(suite[i].name))
            throw Error(suite[i].file.string(), "",
                        "is called as the folder of a shard; give the fixture another name");
        parts.push_back({suite[i].name, keys[i]});
        costs.push_back(fixture_cost(suite[i]));
    }
    return balanced_plan("regress", key, std::move(parts), costs, shards);
}

std::vector<FixtureFile> share_of(std::span<const FixtureFile> suite, const ShardPlan& plan,
                                  int shard) {
    std::vector<FixtureFile> share;
    for (const std::size_t i : share_of(plan, shard)) share.push_back(suite[i]);
    return share;
}

} // namespace keiko
