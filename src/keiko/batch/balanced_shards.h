#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace keiko {

/// Shard of each part, from 1 to `count`, such that shards cost about the same: the most expensive
/// part first, each into the cheapest shard so far. No shard costs more than 4/3 of what the best
/// division would [Graham1969]. Costs are positive; equal ones keep their order.
std::vector<int> balanced_shards(std::span<const double> costs, int count);

/// Cost of reading and judging a body, in seconds of a core or so, from the sizes of its files
/// alone. Files that cannot be read count as empty.
double body_cost(std::span<const std::filesystem::path> files);

/// Cost of pictures, in the unit of body_cost.
double pictures_cost(std::size_t pictures, int width, int height);

} // namespace keiko
