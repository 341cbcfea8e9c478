#include "keiko/geometry/bezier/space_curve.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/structure/face_structure.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

/// A flat sheet of knot spans that are `widths` mm wide in u, and 10 mm in v.
SurfaceModel sheet(const std::vector<double>& widths, double height = 10) {
    NurbsSurface surface{1, 1, {0}, {0, 0, 1, 1}, {}};
    double x = 0, knot = 0;
    const auto column = [&] {
        surface.points.emplace_back(x, 0, 0, 1);
        surface.points.emplace_back(x, height, 0, 1);
        surface.knots_u.push_back(knot);
    };
    column();
    for (const double width : widths) x += width, knot += 1, column();
    surface.knots_u.push_back(knot);
    test::ModelBuilder builder;
    builder.nurbs(surface);
    return builder.build();
}

/// A flat patch by its corners at (u, v) = (0, 0), (0, 1), (1, 0) and (1, 1).
SurfaceModel patch(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    test::ModelBuilder builder;
    builder.patch(1, 1, {a, b, c, d});
    return builder.build();
}

SpanStructure measured(const SurfaceModel& model, const StructureLimits& limits) {
    return span_structure(model, 0, 0, limits);
}

CriteriaPreset preset_of(const StructureLimits& limits) {
    CriteriaPreset preset;
    preset.structure = limits;
    return preset;
}

/// The only check of a code.
Check check_of(const Inspection& inspection, std::string_view code) {
    const auto found = std::find_if(inspection.checks.begin(), inspection.checks.end(),
                                    [&](const Check& check) { return check.code == code; });
    EXPECT_NE(found, inspection.checks.end()) << code;
    return found == inspection.checks.end() ? Check{} : *found;
}

TEST(CurveLength, HoldsThatOfAnArcBetweenItsBounds) {
    const double w = std::sqrt(0.5);
    const LengthRange quarter = curve_length({{3, 0, 0, 1}, {3 * w, 3 * w, 0, w}, {0, 3, 0, 1}});
    const double exact = 1.5 * std::numbers::pi;
    EXPECT_LE(quarter.least, exact);
    EXPECT_GE(quarter.most, exact);
    EXPECT_LT(quarter.bound(), 1e-6 * exact);
}

TEST(CurveLength, HoldsThatOfACurveThatTurnsBack) {
    const LengthRange there_and_back = curve_length({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0, 0, 1}});
    EXPECT_LE(there_and_back.least, 2.0);
    EXPECT_GE(there_and_back.most, 2.0);
    EXPECT_LT(there_and_back.bound(), 1e-5);
}

TEST(SpanStructure, HasTheLargerDegree) {
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 3; ++j) points.emplace_back(i, j, 0);
    builder.patch(12, 3, points);
    StructureLimits limits;
    limits.degree = 11;
    const MeasuredValue above = *measured(builder.build(), limits).degree;
    EXPECT_EQ(above.value, 12);
    EXPECT_EQ(above.verdict, Verdict::fail);
    limits.degree = 12;
    EXPECT_EQ(measured(builder.build(), limits).degree->verdict, Verdict::pass);
}

TEST(SpanStructure, CountsSpansAndNotPatches) {
    StructureLimits limits;
    limits.spans = 2;
    const MeasuredValue three = *measured(sheet({5, 5, 5}), limits).spans;
    EXPECT_EQ(three.value, 3);
    EXPECT_EQ(three.verdict, Verdict::fail);
    EXPECT_EQ(measured(sheet({5, 5}), limits).spans->verdict, Verdict::pass);
}

TEST(SpanStructure, FindsAKnotThatIsTooNearToAnother) {
    StructureLimits limits;
    limits.knot_distance = 0.02;
    const MeasuredValue near = *measured(sheet({50, 0.019, 50}), limits).knot_distance;
    EXPECT_NEAR(near.value, 0.019, 1e-9);
    EXPECT_EQ(near.verdict, Verdict::fail);
    EXPECT_NEAR(near.place.x, 50.0095, 1e-9);
    EXPECT_EQ(measured(sheet({50, 0.021, 50}), limits).knot_distance->verdict, Verdict::pass);
}

/// The parameters of its knots are as near as those of the other sheets are far.
TEST(SpanStructure, MeasuresKnotsInSpace) {
    const double s = std::numbers::sqrt2 / 2;
    test::ModelBuilder builder;
    builder.rational_patch(
        2, 1,
        {{1, 0, 0, 1}, {1, 0, 9, 1}, {s, s, 0, s}, {s, s, 9 * s, s}, {0, 1, 0, 1}, {0, 1, 9, 1}},
        {Vec2(0), Vec2(1e-6)});
    StructureLimits limits;
    limits.knot_distance = 0.02;
    const MeasuredValue wide = *measured(builder.build(), limits).knot_distance;
    EXPECT_EQ(wide.verdict, Verdict::pass);
    EXPECT_LE(wide.value - wide.bound, std::numbers::pi / 2);
    EXPECT_GE(wide.value + wide.bound, std::numbers::pi / 2);
}

/// Both edges across a span are points, and it is wide between them.
TEST(SpanStructure, CannotTellTheWidthOfALensFromItsEdges) {
    test::ModelBuilder builder;
    builder.patch(1, 2, {{0, 0, 0}, {0, 5, 0}, {0, 10, 0}, {0, 0, 0}, {2, 5, 0}, {0, 10, 0}});
    StructureLimits limits;
    limits.knot_distance = 0.02;
    EXPECT_EQ(measured(builder.build(), limits).knot_distance->verdict, Verdict::undecided);
}

TEST(SpanStructure, FindsATinyEdgeOfAPatch) {
    StructureLimits limits;
    limits.patch_edge = 0.2;
    const MeasuredValue tiny = *measured(sheet({50, 0.19, 50}), limits).patch_edge;
    EXPECT_NEAR(tiny.value, 0.19, 1e-9);
    EXPECT_EQ(tiny.verdict, Verdict::fail);
    EXPECT_EQ(measured(sheet({50, 0.21, 50}), limits).patch_edge->verdict, Verdict::pass);
}

TEST(SpanStructure, TellsAPointFromATinyEdge) {
    StructureLimits limits;
    limits.patch_edge = 0.2, limits.degenerate_edge = 0.02;
    const SurfaceModel triangle = patch(Vec3(0), {0, 9, 0}, {9, 0, 0}, {0, 9, 0});
    const SpanStructure of = measured(triangle, limits);
    EXPECT_EQ(of.patch_edge->verdict, Verdict::pass);
    EXPECT_NEAR(of.degenerate_edge->value, 0, 1e-12);
    EXPECT_EQ(of.degenerate_edge->verdict, Verdict::fail);
    EXPECT_NEAR((of.degenerate_edge->place - Vec3(0, 9, 0)).length(), 0, 1e-12);
    const SurfaceModel blunt = patch(Vec3(0), {0, 9, 0}, {9, 0, 0}, {0.03, 9, 0});
    EXPECT_EQ(measured(blunt, limits).degenerate_edge->verdict, Verdict::pass);
    EXPECT_EQ(measured(blunt, limits).patch_edge->verdict, Verdict::fail);
}

TEST(SpanStructure, FindsACornerWhoseEdgesAreNearlyOneLine) {
    StructureLimits limits;
    limits.corner_angle = 2;
    const auto with = [](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 b(0, 9, 0), c(9 * std::sin(angle), 9 * std::cos(angle), 0);
        const Vec3 ahead(std::sin(angle / 2), std::cos(angle / 2), 0);
        return patch(Vec3(0), b, c, (b + c) / 2 + ahead * (b - c).length() / 2);
    };
    for (const double degrees : {1.9, 178.1}) {
        const MeasuredValue sharp = *measured(with(degrees), limits).corner_angle;
        EXPECT_NEAR(sharp.value, 1.9, 1e-9) << degrees;
        EXPECT_EQ(sharp.verdict, Verdict::fail) << degrees;
        EXPECT_NEAR(sharp.place.length(), 0, 1e-12) << degrees;
    }
    EXPECT_EQ(measured(with(90), limits).corner_angle->verdict, Verdict::pass);
}

TEST(SpanStructure, IsThatOfTheFaceAsPlaced) {
    StructureLimits limits;
    limits.patch_edge = 0.2;
    SurfaceModel model = sheet({50, 0.15, 50});
    model.instances[0].transform = test::stretched({2, 2, 2}, {0, 0, 1}, Vec3(0));
    EXPECT_EQ(measured(model, limits).patch_edge->verdict, Verdict::pass);
}

/// A patch drawn out along y, whose rows along u have these points of the plane y = 0.
SurfaceModel row(const std::vector<Vec2>& points) {
    test::ModelBuilder builder;
    std::vector<Vec3> net;
    for (const Vec2& p : points) {
        net.emplace_back(p.x, 0, p.y);
        net.emplace_back(p.x, 10, p.y);
    }
    builder.patch(static_cast<int>(points.size()) - 1, 1, net);
    return builder.build();
}

TEST(ControlNet, MeasuresTheTurnOfARow) {
    StructureLimits limits;
    limits.control_turn = 90;
    const auto with = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec2 bent(10 + 5 * std::cos(angle), 5 * std::sin(angle));
        return *measured(row({Vec2(0), Vec2(10, 0), bent}), limits).control_turn;
    };
    EXPECT_NEAR(with(95).value, 95, 1e-9);
    EXPECT_EQ(with(95).verdict, Verdict::fail);
    EXPECT_NEAR(with(95).place.x, 10, 1e-12);
    EXPECT_NEAR(with(85).value, 85, 1e-9);
    EXPECT_EQ(with(85).verdict, Verdict::pass);
    EXPECT_NEAR(with(180).value, 180, 1e-6);
}

/// A double control point between the two legs hides no turn.
TEST(ControlNet, TurnsOverCoincidentPoints) {
    StructureLimits limits;
    limits.control_turn = 90;
    const SurfaceModel back = row({Vec2(0), Vec2(10, 0), Vec2(10, 0), Vec2(4, 0)});
    EXPECT_NEAR(measured(back, limits).control_turn->value, 180, 1e-6);
}

TEST(ControlNet, MeasuresTheTwistBetweenRows) {
    StructureLimits limits;
    limits.control_twist = 45;
    const auto with = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 way(10 * std::cos(angle), 0, 10 * std::sin(angle));
        return *measured(patch(Vec3(0), {0, 9, 0}, {10, 0, 0}, Vec3(0, 9, 0) + way), limits)
                    .control_twist;
    };
    EXPECT_NEAR(with(50).value, 50, 1e-9);
    EXPECT_EQ(with(50).verdict, Verdict::fail);
    EXPECT_EQ(with(40).verdict, Verdict::pass);
}

TEST(ControlNet, MeasuresTheRatioOfLegs) {
    StructureLimits limits;
    limits.control_ratio = 3;
    const MeasuredValue uneven =
        *measured(row({Vec2(0), Vec2(1, 0), Vec2(4.1, 0)}), limits).control_ratio;
    EXPECT_NEAR(uneven.value, 3.1, 1e-12);
    EXPECT_EQ(uneven.verdict, Verdict::fail);
    EXPECT_EQ(measured(row({Vec2(0), Vec2(2.9, 0), Vec2(3.9, 0)}), limits).control_ratio->verdict,
              Verdict::pass);
    // A point that is there twice makes the ratio as large as rounding lets it be.
    EXPECT_GT(measured(row({Vec2(0), Vec2(1, 0), Vec2(1, 0)}), limits).control_ratio->value, 1e9);
    EXPECT_FALSE(measured(sheet({5}), limits).control_ratio);
}

TEST(ControlNet, FindsPointsThatAreThereTwice) {
    StructureLimits limits;
    limits.control_distance = 0.02;
    const auto with = [&](double distance) {
        return *measured(row({Vec2(0), Vec2(5, 0), Vec2(5 + distance, 0), Vec2(9, 0)}), limits)
                    .control_distance;
    };
    EXPECT_NEAR(with(0.019).value, 0.019, 1e-12);
    EXPECT_EQ(with(0.019).verdict, Verdict::fail);
    EXPECT_EQ(with(0.021).verdict, Verdict::pass);
}

/// An edge that is a point has neither order nor evenness, and its points are one on purpose.
TEST(ControlNet, LeavesPolesAlone) {
    StructureLimits limits;
    limits.control_distance = 0.02, limits.control_turn = 90, limits.control_twist = 90;
    limits.control_ratio = 3;
    const SpanStructure of =
        measured(test::sphere_model(test::stretched(Vec3(100), {0, 0, 1}, Vec3(0))), limits);
    EXPECT_EQ(of.control_distance->verdict, Verdict::pass);
    EXPECT_NEAR(of.control_turn->value, 90, 1e-6);                   // of a quarter of a circle
    EXPECT_NEAR(of.control_ratio->value, std::numbers::sqrt2, 1e-6); // beside a pole
}

/// Planted in a random even net: the one leg, turn or ratio that is worst is found, and where.
TEST(ControlNet, FindsWhatIsPlantedInRandomNets) {
    test::Random random(7);
    for (int k = 0; k < 50; ++k) {
        std::vector<Vec3> points;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 4; ++j)
                points.emplace_back(i * 20 + test::uniform(random, -3, 3),
                                    j * 20 + test::uniform(random, -3, 3),
                                    test::uniform(random, -3, 3));
        const auto planted_at = [&](std::size_t i, std::size_t j) -> Vec3& {
            return points[i * 4 + j];
        };
        const std::size_t i = 1 + test::pick(random, 2), j = test::pick(random, 4);
        const double distance = test::uniform(random, 0.001, 0.0199);
        const bool planted = k % 2 == 0;
        if (planted)
            planted_at(i + 1, j) = planted_at(i, j) + test::random_direction(random) * distance;
        test::ModelBuilder builder;
        builder.patch(4, 3, points);
        StructureLimits limits;
        limits.control_distance = 0.02, limits.control_ratio = 5, limits.control_turn = 90;
        const SpanStructure of = measured(builder.build(), limits);
        EXPECT_EQ(of.control_distance->verdict, planted ? Verdict::fail : Verdict::pass) << k;
        EXPECT_EQ(of.control_ratio->verdict, planted ? Verdict::fail : Verdict::pass) << k;
        if (!planted) {
            EXPECT_EQ(of.control_turn->verdict, Verdict::pass) << k;
            continue;
        }
        EXPECT_NEAR(of.control_distance->value, distance, 1e-9) << k;
        EXPECT_LT((of.control_distance->place - planted_at(i, j)).length(), 0.02) << k;
    }
}

TEST(SpanStructure, MeasuresTheRatioOfNeighbouringSpans) {
    StructureLimits limits;
    limits.width_ratio = 10;
    const MeasuredValue uneven = *measured(sheet({50, 4.9, 20}), limits).width_ratio;
    EXPECT_NEAR(uneven.value, 50 / 4.9, 1e-6);
    EXPECT_EQ(uneven.verdict, Verdict::fail);
    EXPECT_NEAR(uneven.place.x, 52.45, 1e-9);
    EXPECT_EQ(measured(sheet({50, 5.1, 20}), limits).width_ratio->verdict, Verdict::pass);
    EXPECT_FALSE(measured(sheet({50}), limits).width_ratio);
}

TEST(Structure, IsNotJudgedWithoutALimit) {
    const Inspection inspection = inspect(sheet({50, 0.001, 50}));
    for (const Check& check : inspection.checks) EXPECT_EQ(check.face, no_index) << check.code;
}

TEST(Structure, FailsTheFaceAndNamesValueAndLimit) {
    StructureLimits limits;
    limits.knot_distance = 0.02;
    const Inspection inspection = inspect(sheet({50, 0.01, 50}), preset_of(limits));
    const Check check = check_of(inspection, "G-SU-IK");
    EXPECT_EQ(check.rule, "indistinct_surface_knots");
    EXPECT_EQ(check.message, "the narrowest knot span of 0.01 mm is under the limit of 0.02 mm");
    EXPECT_EQ(inspection.faces[0].verdict, Verdict::fail);
    EXPECT_EQ(inspection.verdict, Verdict::fail);
    ASSERT_FALSE(inspection.findings.empty());
}

TEST(Structure, DoesNotJudgePatchesThatAreNotTheFiles) {
    SurfaceModel model = sheet({50, 0.001, 50});
    model.faces[0].surface_kind = "plane";
    StructureLimits limits;
    limits.patch_edge = 0.2;
    const Check check = check_of(inspect(model, preset_of(limits)), "G-SU-TI");
    EXPECT_FALSE(check.judged);
    EXPECT_FALSE(check.is_finding());
}

/// A square of 10 mm with a corner cut off by an edge of the given length.
SurfaceModel cut_square(double edge) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), {10, 0, 0}, {0, 10, 0});
    const double cut = edge / std::numbers::sqrt2 / 10;
    builder.polygon({Vec2(cut, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(0, cut)});
    return builder.build();
}

TEST(Structure, FindsAShortEdgeOfAFace) {
    StructureLimits limits;
    limits.short_edge = 0.02;
    const Check check = check_of(inspect(cut_square(0.015), preset_of(limits)), "G-CU-TI");
    EXPECT_NEAR(check.worst.value, 0.015, 1e-9);
    EXPECT_EQ(check.worst.verdict, Verdict::fail);
    EXPECT_LT(check.worst.place.length(), 0.02);
    EXPECT_EQ(check_of(inspect(cut_square(0.025), preset_of(limits)), "G-CU-TI").worst.verdict,
              Verdict::pass);
}

/// Two p-curves of one edge are one edge, and what closes a loop is none.
TEST(Structure, TakesEdgesAsTheFileHasThem) {
    SurfaceModel model = cut_square(0.015);
    model.edges.resize(5);
    for (std::uint32_t i = 0; i < 5; ++i) model.trim_curves[i].edge = i;
    StructureLimits limits;
    limits.short_edge = 0.02;
    const auto verdict = [&] {
        return check_of(inspect(model, preset_of(limits)), "G-CU-TI").worst.verdict;
    };
    EXPECT_EQ(verdict(), Verdict::fail);
    model.trim_curves[4].edge = 3;
    EXPECT_EQ(verdict(), Verdict::pass);
    model.trim_curves[4].edge = no_index;
    EXPECT_EQ(verdict(), Verdict::pass);
    model.trim_curves[4].edge = 4;
    model.edges[4].degenerate = true;
    EXPECT_EQ(verdict(), Verdict::pass);
}

TEST(Structure, FindsATinyFace) {
    StructureLimits limits;
    limits.small_face = 0.02;
    const auto verdict = [&](double side) {
        return check_of(inspect(sheet({side}, side), preset_of(limits)), "G-FA-TI").worst.verdict;
    };
    EXPECT_EQ(verdict(0.01), Verdict::fail); // its diagonal is 0.0141 mm
    EXPECT_EQ(verdict(0.015), Verdict::pass);
}

} // namespace
} // namespace keiko
