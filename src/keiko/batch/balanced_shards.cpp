#include "keiko/batch/balanced_shards.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <system_error>
#include <utility>

namespace keiko {

std::vector<int> balanced_shards(std::span<const double> costs, int count) {
    std::vector<std::size_t> order(costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
    std::set<std::pair<double, int>> loads; // cost so far and number, the emptiest first
    for (int number = 1; number <= count; ++number) loads.emplace(0, number);
    std::vector<int> shards(costs.size());
    for (const std::size_t part : order) {
        auto emptiest = loads.extract(loads.begin());
        emptiest.value().first += costs[part];
        shards[part] = emptiest.value().second;
        loads.insert(std::move(emptiest));
    }
    return shards;
}

double body_cost(std::span<const std::filesystem::path> files) {
    // Fitted by eye to the fixtures in surfaces: only their order of size matters.
    constexpr double least = 1, per_megabyte = 3, megabyte = 1e6;
    double bytes = 0;
    for (const std::filesystem::path& file : files) {
        std::error_code code;
        const auto size = std::filesystem::file_size(file, code);
        if (!code) bytes += static_cast<double>(size);
    }
    return least + per_megabyte * bytes / megabyte;
}

double pictures_cost(std::size_t pictures, int width, int height) {
    constexpr double per_megapixel = 60;
    return per_megapixel * static_cast<double>(pictures) * width * height / 1e6;
}

} // namespace keiko
