#include "keiko/light/penumbra/width_samples.h"
#include "keiko/light/tubes/lamp_width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

const TubeView view = *view_of({{-700, 40, 900}, {650, -20, 950}, 80, Rgb(1)}, Vec3(0),
                               Vec3(0.1, -0.2, 1).normalized());
const LampWidth width(view, Vec3(0), TubeShape::cylinder, {});
constexpr double spacing = 0.5;

/// Slice where some of the lamp's length begins to be hidden, or ceases to be.
CriticalSlice turn_at(double place, double jump, int dark, bool at_once = true) {
    const SubAxis axis = width.sub_axis(place);
    return {view.sideways * axis.sine - view.towards * axis.cosine, jump * spacing / 2, dark,
            at_once};
}

std::vector<WidthCut> cuts_of(const std::vector<CriticalSlice>& turns, double allowed, bool agree) {
    return PenumbraBreakpoints(width, turns, spacing).cuts(allowed, agree);
}

} // namespace

TEST(PenumbraBreakpoints, CutBothSidesOfABar) {
    const auto cuts = cuts_of({turn_at(0.3, 0.2, -1), turn_at(0.1, 0.2, 1)}, 1e-3, true);
    ASSERT_EQ(cuts.size(), 2u);
    EXPECT_NEAR(cuts[0].begin, 0.1, 1e-9);
    EXPECT_NEAR(cuts[1].begin, 0.3, 1e-9);
    for (const WidthCut& cut : cuts) {
        EXPECT_EQ(cut.begin, cut.end);
        EXPECT_TRUE(cut.jump);
    }
}

/// A bar hides as much of the lamp as of its length and half its width.
TEST(PenumbraBreakpoints, LeaveOutABarThatHidesNoMoreThanIsAllowed) {
    const std::vector<CriticalSlice> bar{turn_at(0.1, 0.2, 1), turn_at(0.3, 0.2, -1)};
    EXPECT_TRUE(cuts_of(bar, 1.01 * 0.2 * 0.2 / 2, true).empty());
    EXPECT_FALSE(cuts_of(bar, 0.99 * 0.2 * 0.2 / 2, true).empty());
}

TEST(PenumbraBreakpoints, TellNothingOfOneSideAloneWhereLinesAgree) {
    EXPECT_TRUE(cuts_of({turn_at(0.1, 1, 1)}, 1e-4, true).empty());
    EXPECT_TRUE(cuts_of({turn_at(0.1, 1, 1), turn_at(0.3, 1, 1)}, 1e-4, true).empty());
    EXPECT_FALSE(cuts_of({turn_at(0.1, 1, 0), turn_at(0.3, 1, 0)}, 1e-4, true).empty());
    EXPECT_EQ(cuts_of({turn_at(0.1, 1, 1), turn_at(0.3, 1, 1)}, 1e-4, false).size(), 2u);
}

/// A line runs between them.
TEST(PenumbraBreakpoints, LeaveOutWhatLinesSeeBetween) {
    EXPECT_TRUE(cuts_of({turn_at(-0.1, 1, 1), turn_at(0.1, 1, -1)}, 1e-4, true).empty());
}

TEST(PenumbraBreakpoints, TellKinksFromJumps) {
    const auto cuts =
        cuts_of({turn_at(0.1, 0.2, 1, false), turn_at(0.3, 0.2, -1, true)}, 1e-3, true);
    ASSERT_EQ(cuts.size(), 2u);
    EXPECT_FALSE(cuts[0].jump);
    EXPECT_TRUE(cuts[1].jump);
}

TEST(PenumbraBreakpoints, AreOneCutWhereLittleIsBetween) {
    constexpr double allowed = 1e-3;
    const auto cuts =
        cuts_of({turn_at(0.1, 1, 1, false), turn_at(0.1 + 0.4 * allowed, 1, -1, false),
                 turn_at(0.1 + 0.8 * allowed, 1, 1, false)},
                allowed, false);
    ASSERT_EQ(cuts.size(), 2u);
    EXPECT_NEAR(cuts[0].begin, 0.1, 1e-9);
    EXPECT_NEAR(cuts[0].end, 0.1 + 0.4 * allowed, 1e-9);
    EXPECT_TRUE(cuts[0].jump);
    EXPECT_NEAR(cuts[1].begin, 0.1 + 0.8 * allowed, 1e-9);
    EXPECT_FALSE(cuts[1].jump);
}

/// Narrow parts between cuts: no more of them is left out than is allowed.
TEST(PenumbraBreakpoints, LeaveOutLittleOfManyNarrowParts) {
    constexpr double allowed = 1e-3;
    std::vector<CriticalSlice> turns;
    for (int i = 0; i < 40; ++i)
        turns.push_back(turn_at(0.2 + 0.1 * allowed * i, 1, i % 2 * 2 - 1));
    double left_out = 0;
    for (const WidthCut& cut : cuts_of(turns, allowed, false)) left_out += cut.end - cut.begin;
    EXPECT_GT(left_out, 0);
    EXPECT_LE(left_out / 2, allowed / 4); // of the whole width
}

} // namespace keiko
