#include "keiko/base/error.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/import/cad/trim_chains.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko::cad {
namespace {

constexpr double turn = 2 * std::numbers::pi;

Chain line(const Vec2& from, const Vec2& to, std::uint32_t edge) {
    LoopCurve curve = connector(from, to);
    curve.edge = edge;
    return {curve};
}

/// A full turn in u, infinite or bounded in v.
ParameterSpace cylinder(double lower_v = -Box2::infinity, double upper_v = Box2::infinity) {
    ParameterSpace space;
    space.period = space.wrap = {turn, 0};
    space.natural = {{0, lower_v}, {turn, upper_v}};
    space.scale = {turn, 1};
    return space;
}

/// The material of loops by the even-odd rule.
TrimRegion region(const std::vector<Chain>& loops) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const Chain& chain : loops) {
        std::vector<std::vector<Vec3>> curves;
        for (const LoopCurve& curve : chain) curves.push_back(curve.points);
        builder.loop(curves);
    }
    const SurfaceModel model = builder.build();
    return {model, model.faces[0]};
}

TEST(WireChain, UsesAWholePeriodOffAreMoved) {
    RepairLog log;
    const auto chains = chain_wire({line({5, 0}, {7, 0}, 0), line({7 - turn, 0}, {7 - turn, 1}, 1),
                                    line({7, 1}, {5, 1}, 2), line({5 + turn, 1}, {5 + turn, 0}, 3)},
                                   cylinder(), log);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].size(), 4u);
    EXPECT_NEAR(begin_of({chains[0][1]}).x, 7, 1e-12);
    EXPECT_NEAR(end_of(chains[0]).x, 5, 1e-12);
    EXPECT_EQ(log.count(RepairKind::p_curve_moved), 2u);
}

TEST(WireChain, UsesInAnyOrderAreSorted) {
    RepairLog log;
    const auto chains = chain_wire({line({0, 0}, {1, 0}, 0), line({1, 1}, {0, 1}, 2),
                                    line({1, 0}, {1, 1}, 1), line({0, 1}, {0, 0}, 3)},
                                   {}, log);
    ASSERT_EQ(chains.size(), 1u);
    ASSERT_EQ(chains[0].size(), 4u);
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(chains[0][i].edge, i);
}

TEST(WireChain, GapsAreBridgedAndTold) {
    RepairLog log;
    auto chains = chain_wire(
        {line({0, 0}, {1, 0}, 0), line({1, 0.01}, {0, 1}, 1), line({0, 1}, {0, 0}, 2)}, {}, log);
    EXPECT_EQ(chains[0].size(), 4u);
    EXPECT_EQ(chains[0][1].edge, no_index);
    ASSERT_EQ(log.repairs().size(), 1u);
    EXPECT_EQ(log.repairs()[0].kind, RepairKind::gap_bridged);
    EXPECT_DOUBLE_EQ(log.repairs()[0].size, 0.01);
}

TEST(WireChain, ASeamThatMeetsItselfAtAPoleGetsThePole) {
    // A sphere whose wire is its seam alone: up on one side, down on the other.
    const double pole = std::numbers::pi / 2;
    RepairLog log;
    const auto chains =
        chain_wire({line({turn, -pole}, {turn, pole}, 0), line({0, pole}, {0, -pole}, 0)},
                   cylinder(-pole, pole), log);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(log.count(RepairKind::degenerate_edge_added), 2u);
    const TrimRegion material = region(close_loops(chains, cylinder(-pole, pole), log).loops);
    for (const double v : {-1.5, 0.0, 1.5})
        for (const double u : {0.1, 3.0, 6.2}) EXPECT_TRUE(material.contains({u, v}));
}

TEST(LoopDirections, AreToldByNesting) {
    const auto square = [](double low, double high, bool clockwise) {
        Chain chain = line({low, low}, {high, low}, 0);
        chain.push_back(connector({high, low}, {high, high}));
        chain.push_back(connector({high, high}, {low, high}));
        chain.push_back(connector({low, high}, {low, low}));
        if (clockwise) reverse(chain);
        return chain;
    };
    EXPECT_EQ(backward_loops({square(0, 9, false), square(1, 8, true), square(2, 7, false)}), 0u);
    EXPECT_EQ(backward_loops({square(0, 9, true)}), 1u);
    EXPECT_EQ(backward_loops({square(0, 9, false), square(1, 8, false)}), 1u);
}

TEST(TightBounds, FollowTheCurveNotItsHull) {
    const Box2 box = tight_bounds({{{Vec3(0, 0, 1), Vec3(1, 2, 1), Vec3(2, 0, 1)}, 0}});
    EXPECT_NEAR(box.upper.y, 1, 1e-8);
    EXPECT_GE(box.upper.y, 1);
}

TEST(CloseLoops, TwoCirclesAroundACylinderBoundABand) {
    for (const double start : {0.0, 2.0, -5.0}) {
        RepairLog log;
        const ClosedLoops closed = close_loops(
            {line({0, 1}, {turn, 1}, 0), line({start + turn, 3}, {start, 3}, 1)}, cylinder(), log);
        ASSERT_EQ(closed.loops.size(), 1u);
        EXPECT_NEAR(closed.domain.extent().x, turn, 1e-9);
        EXPECT_NEAR(closed.domain.lower.y, 1, 1e-12);
        EXPECT_NEAR(closed.domain.upper.y, 3, 1e-12);
        const TrimRegion material = region(closed.loops);
        for (const double u : {0.1, 1.9, 2.1, 6.2}) {
            EXPECT_TRUE(material.contains({u, 2})) << start << " " << u;
            EXPECT_FALSE(material.contains({u, 0.5}));
            EXPECT_FALSE(material.contains({u, 3.5}));
        }
    }
}

TEST(CloseLoops, ALoneCircleClosesOverThePoleOnItsLeft) {
    RepairLog log;
    const double pole = std::numbers::pi / 2;
    const auto north = close_loops({line({0, 0.5}, {turn, 0.5}, 0)}, cylinder(-pole, pole), log);
    EXPECT_TRUE(region(north.loops).contains({3, 1}));
    EXPECT_FALSE(region(north.loops).contains({3, 0}));
    const auto south = close_loops({line({turn, 0.5}, {0, 0.5}, 0)}, cylinder(-pole, pole), log);
    EXPECT_TRUE(region(south.loops).contains({3, -1}));
    EXPECT_FALSE(region(south.loops).contains({3, 1}));
}

TEST(CloseLoops, ALoneCircleOnAnInfiniteCylinderBoundsNothing) {
    RepairLog log;
    EXPECT_THROW(close_loops({line({0, 1}, {turn, 1}, 0)}, cylinder(), log), Error);
}

TEST(CloseLoops, AHoleIsMovedToItsFaceAndDoubledAcrossTheSeam) {
    const auto square = [](double u, double v) {
        Chain chain;
        const Vec2 corners[] = {{u, v}, {u + 1, v}, {u + 1, v + 1}, {u, v + 1}, {u, v}};
        for (int i = 0; i < 4; ++i) chain.push_back(connector(corners[i], corners[i + 1]));
        return chain;
    };
    Chain outer;
    const Vec2 corners[] = {{0, 0}, {turn, 0}, {turn, 5}, {0, 5}, {0, 0}};
    for (int i = 0; i < 4; ++i) outer.push_back(connector(corners[i], corners[i + 1]));
    RepairLog log;
    const ClosedLoops closed =
        close_loops({outer, square(turn + 2, 1), square(-0.5, 3)}, cylinder(), log);
    EXPECT_EQ(closed.loops.size(), 4u);
    EXPECT_NEAR(closed.domain.upper.x, turn, 1e-9);
    const TrimRegion material = region(closed.loops);
    EXPECT_FALSE(material.contains({2.5, 1.5}));
    EXPECT_FALSE(material.contains({0.25, 3.5}));
    EXPECT_FALSE(material.contains({turn - 0.25, 3.5}));
    EXPECT_TRUE(material.contains({3, 3.5}));
}

TEST(CloseLoops, WithoutLoopsTheFaceIsItsNaturalDomain) {
    RepairLog log;
    ParameterSpace space;
    space.natural = {{1, 2}, {3, 4}};
    const ClosedLoops closed = close_loops({}, space, log);
    EXPECT_TRUE(closed.loops.empty());
    EXPECT_EQ(closed.domain, space.natural);
}

} // namespace
} // namespace keiko::cad
