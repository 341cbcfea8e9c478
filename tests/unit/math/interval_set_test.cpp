#include "keiko/math/interval_set.h"

#include <gtest/gtest.h>

#include <random>

using namespace keiko;

namespace {

IntervalSet random_set(std::mt19937& random) {
    std::uniform_real_distribution<double> at(0, 1);
    std::vector<ParameterInterval> intervals(random() % 6);
    for (auto& interval : intervals) {
        const double begin = at(random);
        interval = {begin, begin + 0.2 * at(random)};
    }
    return IntervalSet(std::move(intervals));
}

} // namespace

TEST(IntervalSet, SortsJoinsAndDropsEmptyOnes) {
    const IntervalSet set({{0.5, 0.7}, {0.1, 0.2}, {0.2, 0.3}, {0.9, 0.9}, {0.8, 0.75}});
    ASSERT_EQ(set.size(), 2u);
    EXPECT_EQ(set[0], (ParameterInterval{0.1, 0.3}));
    EXPECT_EQ(set[1], (ParameterInterval{0.5, 0.7}));
    EXPECT_DOUBLE_EQ(set.measure(), 0.4);
}

TEST(IntervalSet, OperationsAgreeWithMembershipPointByPoint) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(0, 1);
    for (int round = 0; round < 500; ++round) {
        const IntervalSet a = random_set(random), b = random_set(random);
        const IntervalSet both = a.intersect(b), either = a.unite(b), none = a.complement();
        for (int i = 0; i < 20; ++i) {
            const double t = at(random);
            EXPECT_EQ(both.contains(t), a.contains(t) && b.contains(t));
            EXPECT_EQ(either.contains(t), a.contains(t) || b.contains(t));
            EXPECT_EQ(none.contains(t), !a.contains(t));
        }
        EXPECT_NEAR(a.measure() + b.measure(), both.measure() + either.measure(), 1e-12);
    }
}

TEST(IntervalSet, ComplementOfNothingIsTheWhole) {
    EXPECT_EQ(IntervalSet().complement(), IntervalSet::whole());
    EXPECT_TRUE(IntervalSet::whole().complement().empty());
}

// Sets of none to five intervals, kept in place or not.
TEST(IntervalSet, BetweenTwoOfOneSizeEndsMoveEvenly) {
    std::mt19937 random(5);
    int compared = 0;
    for (int round = 0; round < 500; ++round) {
        const IntervalSet a = random_set(random), b = random_set(random);
        EXPECT_EQ(IntervalSet::between(a, a, 0.3), a);
        if (a.size() != b.size()) continue;
        const IntervalSet middle = IntervalSet::between(a, b, 0.5);
        ASSERT_EQ(middle.size(), a.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_DOUBLE_EQ(middle[i].begin, (a[i].begin + b[i].begin) / 2);
            EXPECT_DOUBLE_EQ(middle[i].end, (a[i].end + b[i].end) / 2);
        }
        EXPECT_EQ(IntervalSet::between(a, b, 0), a);
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

TEST(IntervalSet, IsEmptyWhenMovedFromIfItIsLarge) {
    IntervalSet set({{0, 0.1}, {0.2, 0.3}, {0.4, 0.5}});
    const IntervalSet moved = std::move(set);
    EXPECT_EQ(moved.size(), 3u);
    EXPECT_EQ(set.size(), 0u);
    EXPECT_EQ(set.begin(), set.end());
}

TEST(IntervalSet, WholeOfNothingIsEmpty) {
    EXPECT_TRUE(IntervalSet::whole(0.5, 0.5).empty());
    EXPECT_TRUE(IntervalSet::whole(0.5, 0.4).empty());
    EXPECT_EQ(IntervalSet::whole(0.2, 0.7), IntervalSet({{0.2, 0.7}}));
}
