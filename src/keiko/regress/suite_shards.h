#pragma once

#include "keiko/batch/shard_plan.h"
#include "keiko/files/scene/fixture_file.h"

#include <span>
#include <string>
#include <vector>

namespace keiko {

/// Plan of the shards of a suite with a key, whose outcomes have `keys`. The cost of a fixture
/// follows from the sizes of its models and pictures. Throws Error for a fixture that has the name
/// of a shard's folder.
ShardPlan suite_plan(std::span<const FixtureFile> suite, std::span<const std::string> keys,
                     const std::string& key, int shards);

/// The fixtures of a shard, in the order of the suite.
std::vector<FixtureFile> share_of(std::span<const FixtureFile> suite, const ShardPlan& plan,
                                  int shard);

} // namespace keiko
