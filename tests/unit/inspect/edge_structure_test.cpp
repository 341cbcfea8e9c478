#include "keiko/inspect/structure/edge_structure.h"

#include "keiko/inspect/inspection.h"
#include "keiko/inspect/structure/loop_crossings.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

using Curve = std::vector<Vec3>;

Curve line(const Vec2& a, const Vec2& b) {
    return {Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)};
}

/// A square of 10 mm, its parameters in mm, with a loop of curves on given edges.
SurfaceModel trimmed_square(const std::vector<Curve>& curves,
                            const std::vector<std::uint32_t>& edges) {
    test::ModelBuilder builder;
    builder.patch(1, 1, {{0, 0, 0}, {0, 10, 0}, {10, 0, 0}, {10, 10, 0}}, {Vec2(0), Vec2(10)});
    builder.loop(curves);
    SurfaceModel model = builder.build();
    model.edges.resize(curves.size());
    for (std::size_t i = 0; i < edges.size(); ++i) model.trim_curves[i].edge = edges[i];
    return model;
}

EdgeStructure measured(const SurfaceModel& model, const StructureLimits& limits) {
    const auto found = edge_structures(model, {{{0, 0}, limits}});
    return found.empty() ? EdgeStructure{} : found.at({0, 0});
}

/// The lower side is one edge of two curves that meet at (5, 0) at an angle.
SurfaceModel kinked(double degrees) {
    const double rise = 5 * std::tan(degrees / 2 * std::numbers::pi / 180);
    return trimmed_square({line({0, 0}, {5, rise}), line({5, rise}, {10, 0}),
                           line({10, 0}, {10, 10}), line({10, 10}, {0, 10}), line({0, 10}, {0, 0})},
                          {0, 0, 1, 2, 3});
}

TEST(EdgeStructure, MeasuresTheKinkInsideAnEdge) {
    StructureLimits limits;
    limits.edge_angle = 0.1;
    const MeasuredValue kink = *measured(kinked(0.11), limits).angle;
    EXPECT_NEAR(kink.value, 0.11, 1e-9);
    EXPECT_EQ(kink.verdict, Verdict::fail);
    EXPECT_NEAR(kink.place.x, 5, 1e-9);
    EXPECT_EQ(measured(kinked(0.09), limits).angle->verdict, Verdict::pass);
}

/// Corners between edges are not inside one.
TEST(EdgeStructure, DoesNotTakeCornersForKinks) {
    StructureLimits limits;
    limits.edge_angle = 0.1;
    SurfaceModel model = kinked(5);
    model.trim_curves[1].edge = 4;
    EXPECT_FALSE(measured(model, limits).angle);
}

TEST(EdgeStructure, MeasuresTheGapThatTheImportHasBridged) {
    StructureLimits limits;
    limits.edge_gap = 0.02;
    const auto with = [](double gap) {
        SurfaceModel model = trimmed_square(
            {line({0, 0}, {10 - gap, 0}), line({10 - gap, 0}, {10, 0}), line({10, 0}, {10, 10}),
             line({10, 10}, {0, 10}), line({0, 10}, {0, 0})},
            {0, no_index, 1, 2, 3});
        model.repairs.push_back({1, RepairKind::gap_bridged, 1, gap, ""});
        return model;
    };
    const MeasuredValue gap = *measured(with(0.021), limits).gap;
    EXPECT_NEAR(gap.value, 0.021, 1e-12);
    EXPECT_EQ(gap.verdict, Verdict::fail);
    EXPECT_NEAR(gap.place.x, 10, 0.02);
    EXPECT_EQ(measured(with(0.019), limits).gap->verdict, Verdict::pass);
}

/// Pieces that close a loop, as the sides of a band do, have no edge and bridge no gap.
TEST(EdgeStructure, LeavesConnectingPiecesAlone) {
    StructureLimits limits;
    limits.edge_gap = 0.02;
    SurfaceModel model = trimmed_square({line({0, 0}, {10, 0}), line({10, 0}, {10, 10}),
                                         line({10, 10}, {0, 10}), line({0, 10}, {0, 0})},
                                        {0, no_index, 1, no_index});
    EXPECT_FALSE(measured(model, limits).gap);
}

TEST(EdgeStructure, HasTheHighestDegreeOfItsCurves) {
    StructureLimits limits;
    limits.edge_degree = 11;
    const auto with = [](int degree) {
        Curve low;
        for (int i = 0; i <= degree; ++i) low.emplace_back(10.0 * i / degree, 0, 1);
        return trimmed_square(
            {low, line({10, 0}, {10, 10}), line({10, 10}, {0, 10}), line({0, 10}, {0, 0})},
            {0, 1, 2, 3});
    };
    EXPECT_EQ(measured(with(12), limits).degree->value, 12);
    EXPECT_EQ(measured(with(12), limits).degree->verdict, Verdict::fail);
    EXPECT_EQ(measured(with(11), limits).degree->verdict, Verdict::pass);
}

TEST(EdgeStructure, FindsAShortCurveOfAnEdge) {
    StructureLimits limits;
    limits.edge_knot_distance = 0.02;
    const auto with = [](double length) {
        return trimmed_square(
            {line({0, 0}, {4, 0}), line({4, 0}, {4 + length, 0}), line({4 + length, 0}, {10, 0}),
             line({10, 0}, {10, 10}), line({10, 10}, {0, 10}), line({0, 10}, {0, 0})},
            {0, 0, 0, 1, 2, 3});
    };
    const MeasuredValue curve = *measured(with(0.019), limits).knot_distance;
    EXPECT_NEAR(curve.value, 0.019, 1e-12);
    EXPECT_EQ(curve.verdict, Verdict::fail);
    EXPECT_EQ(measured(with(0.021), limits).knot_distance->verdict, Verdict::pass);
}

/// The crossing of the loops of a square of 10 mm that are polygons of these corners, in mm.
std::optional<LoopCrossing> crossing_of(const std::vector<std::vector<Vec2>>& polygons,
                                        double least = 0.02) {
    test::ModelBuilder builder;
    builder.patch(1, 1, {{0, 0, 0}, {0, 10, 0}, {10, 0, 0}, {10, 10, 0}}, {Vec2(0), Vec2(10)});
    for (const std::vector<Vec2>& polygon : polygons) builder.polygon(polygon);
    const SurfaceModel model = builder.build();
    const ModelBorders borders(model);
    return loop_crossing(borders, borders.curves.loops(), least);
}

TEST(LoopCrossing, FindsABowTie) {
    const auto crossing = crossing_of({{Vec2(1, 1), Vec2(9, 9), Vec2(9, 1), Vec2(1, 5)}});
    ASSERT_TRUE(crossing);
    // The diagonal meets the line from (9, 1) to (1, 5) at (11, 11) / 3.
    EXPECT_NEAR(crossing->place.x, 11.0 / 3, 1e-9);
    EXPECT_NEAR(crossing->place.y, 11.0 / 3, 1e-9);
    const double part = std::hypot(8.0 / 3, 8.0 / 3) + 4 + std::hypot(8.0 / 3, 4.0 / 3);
    EXPECT_NEAR(crossing->length, part, 1e-9);
    EXPECT_FALSE(crossing->of_two_loops);
}

/// Sides that overshoot their corner and come back: the part beyond is twice that and its end.
TEST(LoopCrossing, MeasuresWhatACornerOvershoots) {
    const auto with = [](double over) {
        return crossing_of({{Vec2(0), Vec2(5 + over, 0), Vec2(5, -over), Vec2(5, 5), Vec2(0, 5)}});
    };
    const auto crossing = with(0.01);
    ASSERT_TRUE(crossing);
    EXPECT_NEAR(crossing->length, 0.01 * (2 + std::numbers::sqrt2), 1e-9);
    EXPECT_FALSE(with(0.005));
}

TEST(LoopCrossing, FindsLoopsThatCrossEachOther) {
    const auto crossing = crossing_of(
        {{Vec2(0), Vec2(6, 0), Vec2(6), Vec2(0, 6)}, {Vec2(4), Vec2(9, 4), Vec2(9), Vec2(4, 9)}});
    ASSERT_TRUE(crossing);
    EXPECT_TRUE(crossing->of_two_loops);
    EXPECT_NEAR(crossing->length, 4, 1e-9);
}

TEST(LoopCrossing, LeavesCleanLoopsAlone) {
    EXPECT_FALSE(crossing_of(
        {{Vec2(0), Vec2(9, 0), Vec2(9), Vec2(0, 9)}, {Vec2(2), Vec2(2, 4), Vec2(4), Vec2(4, 2)}}));
    // A slit, and two loops that touch in a corner.
    EXPECT_FALSE(crossing_of({{Vec2(0), Vec2(9, 0), Vec2(9), Vec2(5, 9), Vec2(5, 3), Vec2(5, 9)}}));
    EXPECT_FALSE(crossing_of(
        {{Vec2(0), Vec2(5, 0), Vec2(5), Vec2(0, 5)}, {Vec2(5), Vec2(8, 5), Vec2(8), Vec2(5, 8)}}));
}

TEST(LoopCrossing, FindsACurveThatCrossesItself) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), {10, 0, 0}, {0, 10, 0});
    builder.loop({{Vec3(0.4, 0.2, 1), Vec3(0.9, 0.8, 1), Vec3(0.1, 0.8, 1), Vec3(0.6, 0.2, 1)},
                  line({0.6, 0.2}, {0.5, 0.05}),
                  line({0.5, 0.05}, {0.4, 0.2})});
    const SurfaceModel model = builder.build();
    const ModelBorders borders(model);
    const auto crossing = loop_crossing(borders, borders.curves.loops(), 0.02);
    ASSERT_TRUE(crossing);
    EXPECT_NEAR(crossing->place.x, 5, 1e-9);
}

/// Number of pairs of sides of a polygon that cross. Sides that follow each other do not count.
int crossing_sides(const std::vector<Vec2>& corners) {
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const std::size_t n = corners.size();
    int count = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            if (i == 0 && k == n - 1) continue;
            const Vec2 &a = corners[i], &b = corners[i + 1], &c = corners[k],
                       &d = corners[(k + 1) % n];
            count += side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
        }
    return count;
}

TEST(LoopCrossing, AgreesWithBruteForceOnRandomPolygons) {
    test::Random random(11);
    int crossed = 0, clean = 0;
    for (int k = 0; k < 200; ++k) {
        std::vector<Vec2> corners;
        const int n = 4 + static_cast<int>(test::pick(random, 6));
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n, r = test::uniform(random, 1, 4.9);
            corners.emplace_back(5 + r * std::cos(angle), 5 + r * std::sin(angle));
        }
        if (k % 2) std::swap(corners[test::pick(random, 2)], corners[2 + test::pick(random, 2)]);
        const bool crosses = crossing_sides(corners) > 0;
        EXPECT_EQ(crossing_of({corners}, 1e-6).has_value(), crosses) << k;
        ++(crosses ? crossed : clean);
    }
    EXPECT_GT(crossed, 30);
    EXPECT_GT(clean, 90);
}

TEST(EdgeStructure, IsJudgedWithItsNames) {
    CriteriaPreset preset;
    preset.structure.edge_angle = 0.1, preset.structure.loop_crossing = 0.02;
    const Inspection inspection = inspect(kinked(0.2), preset);
    const auto found = std::find_if(inspection.findings.begin(), inspection.findings.end(),
                                    [](const Check& check) { return check.code == "G-CU-NT"; });
    ASSERT_NE(found, inspection.findings.end());
    EXPECT_EQ(found->rule, "g1_discontinuous_curve");
    EXPECT_EQ(found->message,
              "the kink of an edge of 0.2 degrees is over the limit of 0.1 degrees");
}

} // namespace
} // namespace keiko
