#include "keiko/batch/balanced_shards.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace keiko {
namespace {

std::vector<double> loads(const std::vector<double>& costs, const std::vector<int>& shards,
                          int count) {
    std::vector<double> sums(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < costs.size(); ++i)
        sums.at(static_cast<std::size_t>(shards[i]) - 1) += costs[i];
    return sums;
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

/// Cost of the most expensive shard of the best division, by trying all of them.
double best_division(const std::vector<double>& costs, int count) {
    std::vector<int> shards(costs.size(), 1);
    double best = largest(loads(costs, shards, count));
    for (;;) {
        std::size_t digit = 0;
        while (digit < shards.size() && shards[digit] == count) shards[digit++] = 1;
        if (digit == shards.size()) return best;
        ++shards[digit];
        best = std::min(best, largest(loads(costs, shards, count)));
    }
}

TEST(BalancedShards, TakeTheMostExpensivePartFirst) {
    EXPECT_EQ(balanced_shards(std::vector<double>{1, 1, 4, 2}, 2), (std::vector{2, 2, 1, 2}));
    EXPECT_EQ(balanced_shards(std::vector<double>{1, 1, 1, 1, 1}, 2), (std::vector{1, 2, 1, 2, 1}));
    EXPECT_EQ(balanced_shards(std::vector<double>{3}, 4), std::vector{1});
    EXPECT_TRUE(balanced_shards({}, 3).empty());
}

TEST(BalancedShards, StayWithinGrahamsBoundOfTheBestDivision) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> cost(0.1, 10);
    for (int turn = 0; turn < 200; ++turn) {
        const int count = 2 + turn % 2;
        std::vector<double> costs(static_cast<std::size_t>(3 + turn % 6));
        std::generate(costs.begin(), costs.end(), [&] { return cost(random); });
        const double most = largest(loads(costs, balanced_shards(costs, count), count));
        const double bound = 4.0 / 3 - 1.0 / (3 * count);
        EXPECT_LE(most, best_division(costs, count) * bound * (1 + 1e-12)) << turn;
    }
}

TEST(BodyCost, GrowsWithTheFiles) {
    const test::TemporaryFolder folder;
    const std::filesystem::path small = folder.file("small", std::string(1000, 'x')),
                                large = folder.file("large", std::string(1'000'000, 'x'));
    const auto cost = [](const std::vector<std::filesystem::path>& files) {
        return body_cost(files);
    };
    EXPECT_GT(cost({}), 0);
    EXPECT_LT(cost({small}), cost({large}));
    EXPECT_LT(cost({large}), cost({large, small}));
    EXPECT_EQ(cost({folder.path() / "nowhere"}), cost({}));
}

TEST(PicturesCost, IsThatOfTheirPixels) {
    EXPECT_EQ(pictures_cost(0, 960, 540), 0);
    EXPECT_DOUBLE_EQ(pictures_cost(2, 960, 540), 2 * pictures_cost(1, 960, 540));
    EXPECT_DOUBLE_EQ(pictures_cost(1, 960, 540), 4 * pictures_cost(1, 480, 270));
}

} // namespace
} // namespace keiko
