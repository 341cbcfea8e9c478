// Notches, slits and small holes between free edges.
#include "keiko/inspect/openings/opening.h"

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/openings/free_edges.h"

#include "tests/unit/inspect/notched_sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test::notched;

constexpr double join = 0.5;

std::vector<Opening> openings_of(const SurfaceModel& model) {
    const auto seams = measure_seams(model, pair_seams(model, join), {}, join);
    const BoundaryCurves curves(model);
    const FreeEdges edges = free_edges(curves, seams.pieces, 0.01, join);
    return find_openings(curves, edges, {join, 0.1, 0.01});
}

TEST(Openings, AreNoneAlongAClosedSeam) {
    EXPECT_TRUE(openings_of(notched_model({})).empty());
    EXPECT_TRUE(openings_of(notched_model({{70, 0}, {20, 0}})).empty());
}

TEST(Openings, AreNotchesWhateverTheAngleOfTheirFlanks) {
    for (const double flank : {11.0, 30.0, 45.0, 60.0, 80.0})
        for (const double deep : {3.0, 5.0, 20.0}) {
            const double half = deep / std::tan(degrees_to_radians(flank));
            if (half > 40) continue;
            const auto found =
                openings_of(notched_model({{50 + half, 0}, {50, -deep}, {50 - half, 0}}));
            ASSERT_GE(found.size(), 1u) << flank << " degrees, " << deep << " mm";
            EXPECT_GT(found.front().width, 0.05);
            EXPECT_NEAR(found.front().place.x, 50, half + 1);
        }
}

TEST(Openings, OrGapsOfASeamThatFailAreSmallNotches) {
    for (const double flank : {11.0, 30.0, 45.0, 60.0, 80.0})
        for (const double deep : {0.1, 0.3, 0.6, 1.0}) {
            const double half = deep / std::tan(degrees_to_radians(flank));
            const SurfaceModel model = notched_model({{50 + half, 0}, {50, -deep}, {50 - half, 0}});
            if (openings_of(model).empty()) {
                EXPECT_EQ(inspect(model).verdict, Verdict::fail) << flank << ", " << deep << " mm";
            }
        }
}

TEST(Openings, AreDeepSlitsOfOneFaceThatBeginAtASeam) {
    const auto found = openings_of(notched_model({{50.6, 0}, {50.6, -20}, {49.4, -20}, {49.4, 0}}));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found.front().length, 20, 1.1);
    EXPECT_FALSE(found.front().goes_on);
}

TEST(Openings, AreNotchesAtACrease) {
    for (const Vec3& other : {Vec3(0, 0, 50), Vec3(0, 20, 50), Vec3(0, -20, 50), Vec3(0, -50, 20)})
        for (const double deep : {1.0, 5.0, 20.0}) {
            test::ModelBuilder builder;
            builder.plane({0, 0, 0}, {length, 0, 0}, other);
            notched_sheet(builder, bordered({{50 + deep, 0}, {50, -deep}, {50 - deep, 0}}));
            const auto found = openings_of(builder.build());
            ASSERT_EQ(found.size(), 1u) << other.y << ", " << deep << " mm";
            EXPECT_NEAR(found.front().width, deep, 1e-6);
            EXPECT_NEAR(found.front().length, 2 * deep, 1e-6);
        }
}

TEST(Openings, AreTallHolesAcrossASeam) {
    struct Hole {
        std::vector<Vec2> lower, upper;
        double width, length;
    };
    const double tip = std::atan(1.0 / 3);
    for (const Hole& hole : {Hole{{{53, 0}, {50, -9}, {47, 0}},
                                  {{47, 0}, {50, 9}, {53, 0}},
                                  6 * std::cos(tip),
                                  18 * std::cos(tip)},
                             Hole{{{50.5, 0}, {50.5, -10}, {49.5, -10}, {49.5, 0}},
                                  {{49.5, 0}, {49.5, 10}, {50.5, 10}, {50.5, 0}},
                                  1,
                                  20}}) {
        const auto found = openings_of(holed_model(hole.lower, hole.upper));
        ASSERT_EQ(found.size(), 1u) << hole.length;
        EXPECT_NEAR(found.front().width, hole.width, 1e-6);
        EXPECT_NEAR(found.front().length, hole.length, 1e-6);
        EXPECT_LT((found.front().place - Vec3(50, 0, 0)).length(), 1e-6);
    }
}

/// A whole sheet beside one whose border runs through `border`, x and mm out of the plane.
SurfaceModel risen_border(const std::vector<Vec2>& border) {
    test::ModelBuilder builder;
    whole_sheet(builder);
    NurbsSurface risen{1, 1, {0}, {0, 0, 1, 1}, {}};
    for (std::size_t i = 0; i < border.size(); ++i) {
        risen.knots_u.push_back(double(i));
        risen.points.emplace_back(border[i].x, 0, border[i].y, 1);
        risen.points.emplace_back(border[i].x, -depth, 0, 1);
    }
    risen.knots_u.push_back(double(border.size() - 1));
    builder.nurbs(risen);
    return builder.build();
}

TEST(Openings, AreTearsAcrossTheSheets) {
    for (const double high : {0.45, 2.0, 8.0})
        for (const double flank : {11.0, 30.0, 80.0}) {
            const double run = high / std::tan(degrees_to_radians(flank));
            const SurfaceModel torn = risen_border(
                {{0, 0}, {45 - run, 0}, {45, high}, {55, high}, {55 + run, 0}, {length, 0}});
            EXPECT_FALSE(inspect(torn).verdict == Verdict::pass && openings_of(torn).empty())
                << high << " mm, " << flank << " degrees";
        }
    EXPECT_TRUE(openings_of(risen_border({{0, 0}, {45, 0}, {length, 0}})).empty());
}

TEST(Openings, AreHolesBetweenInstancesOfOneFace) {
    test::ModelBuilder builder;
    notched_sheet(builder, bordered({{51, 0}, {50, -2}, {49, 0}}));
    builder.instance({});
    const Affine turned{{Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1)}, {length, 0, 0}};
    builder.instance(turned);
    const auto found = openings_of(builder.build());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found.front().sides[0].instance, found.front().sides[1].instance);
    EXPECT_NEAR(found.front().width, 4 / std::sqrt(5.0), 1e-6);
}

TEST(Openings, AreSlitsFromAFreeEdgeToASeam) {
    // The seam ends at x = 40; beyond it the lower sheet turns away by 30 degrees.
    const double away = 60 * std::tan(degrees_to_radians(30));
    test::ModelBuilder builder;
    whole_sheet(builder);
    notched_sheet(builder, {{length, -away}, {40, 0}, {0, 0}});
    const auto found = openings_of(builder.build());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found.front().goes_on);
    EXPECT_NEAR(found.front().width, 2 * 25 * std::sin(degrees_to_radians(15)), 1);
}

TEST(Openings, AreTriangularHolesAtACornerOfThreeFaces) {
    for (const double c : {0.2, 0.45, 0.8, 5.0, 15.0}) {
        test::ModelBuilder builder;
        builder.plane({0, -depth, 0}, {length, 0, 0}, {0, depth, 0});
        builder.plane({0, 0, 0}, {50, 0, 0}, {0, depth, 0});
        builder.polygon({{0, 0}, {1 - c / 50, 0}, {1, c / 50}, {1, 1}, {0, 1}});
        builder.plane({50, 0, 0}, {50, 0, 0}, {0, depth, 0});
        builder.polygon({{c / 50, 0}, {1, 0}, {1, 1}, {0, 1}, {0, c / 50}});
        const auto found = openings_of(builder.build());
        ASSERT_EQ(found.size(), 1u) << c;
        EXPECT_NEAR(found.front().width, c, 0.5 * c);
    }
}

TEST(Openings, AreNoTeethLowerThanTheJoinDistance) {
    std::vector<Vec2> teeth;
    for (int i = 1; i < 500; ++i) teeth.emplace_back(length - 0.2 * i, i % 2 ? -0.05 : 0);
    const SurfaceModel model = notched_model(teeth);
    const Inspection found = inspect(model);
    EXPECT_EQ(found.verdict, Verdict::fail);
    ASSERT_EQ(found.seams.size(), 1u);
    EXPECT_NEAR(found.seams.front().length, length, 0.5);
    // The flanks beside the corners of the sheet stay free.
    for (const Opening& opening : openings_of(model)) EXPECT_LT(opening.width, 0.05);
}

TEST(Openings, AreNoNotchesLowerThanTheJoinDistance) {
    for (const double flank : {11.0, 30.0, 60.0}) {
        const double deep = 0.3, half = deep / std::tan(degrees_to_radians(flank));
        const SurfaceModel model = notched_model({{50 + half, 0}, {50, -deep}, {50 - half, 0}});
        EXPECT_TRUE(openings_of(model).empty()) << flank;
        const Inspection found = inspect(model);
        EXPECT_EQ(found.verdict, Verdict::fail) << flank;
        ASSERT_EQ(found.findings.size(), 1u) << flank;
        // From the notch, or from the straight border to the nearest flank.
        const double value = found.findings[0].worst.value;
        EXPECT_GE(value, deep * std::cos(degrees_to_radians(flank)) - 1e-9) << flank;
        EXPECT_LE(value, deep + 1e-9) << flank;
    }
}

/// Two halves of a cone, mm: the radii of its rims.
SurfaceModel tube(double first, double other) {
    test::ModelBuilder builder;
    const double w = std::sqrt(0.5);
    for (const double up : {1.0, -1.0}) {
        std::vector<Vec4> points;
        for (const auto& [x, r] : {std::array{0.0, first}, std::array{30.0, other}})
            for (const auto& [y, z, weight] :
                 {std::array{r, 0.0, 1.0}, std::array{r, r * up, w}, std::array{0.0, r * up, 1.0},
                  std::array{-r, r * up, w}, std::array{-r, 0.0, 1.0}})
                points.emplace_back(x * weight, y * weight, z * weight, weight);
        builder.nurbs({1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, points});
    }
    return builder.build();
}

TEST(Openings, AreNotTheRimsOfTubes) {
    EXPECT_TRUE(openings_of(tube(2, 2)).empty());
    EXPECT_TRUE(openings_of(tube(2, 6)).empty());
}

TEST(Openings, HaveABoundThatHoldsForLargeArcs) {
    const double radius = 20000;
    const SurfaceModel model = tube(radius, radius);
    const FreeEdges edges = free_edges(BoundaryCurves(model), {}, 0.01, join);
    double largest = 0;
    for (const FreeEdge& edge : edges.all)
        for (std::size_t i = 0; i + 1 < edge.places.size(); ++i) {
            const Vec3 middle = (edge.places[i].position + edge.places[i + 1].position) / 2;
            if (edge.places[i].position.x != edge.places[i + 1].position.x) continue;
            const double sagitta = radius - std::hypot(middle.y, middle.z);
            EXPECT_LE(sagitta, edge.deviation * (1 + 1e-3));
            largest = std::max(largest, sagitta);
        }
    EXPECT_GT(largest, 0.005);
}

TEST(Openings, AreNotTheBordersOfSmallParts) {
    for (const Vec3& other : {Vec3(0, 4, 0), Vec3(0, 0, 4), Vec3(0, -2, 4)}) {
        test::ModelBuilder builder;
        builder.plane({0, -4, 0}, {8, 0, 0}, {0, 4, 0});
        builder.plane({0, 0, 0}, {8, 0, 0}, other);
        EXPECT_TRUE(openings_of(builder.build()).empty()) << other.y;
    }
}

TEST(Openings, AreNoCornersOfWideCutOutsNorOfPanels) {
    // Of one sheet, 80 mm by 30 mm and 30 mm by 30 mm.
    for (const double half : {40.0, 15.0}) {
        const double right = 50 + half, left = 50 - half;
        EXPECT_TRUE(
            openings_of(notched_model({{right, 0}, {right, -30}, {left, -30}, {left, 0}})).empty());
    }
}

TEST(Openings, AreCutOutsWithASideThatIsShort) {
    const auto one = openings_of(notched_model({{60, 0}, {60, -20}, {40, -20}, {40, 0}}));
    ASSERT_EQ(one.size(), 1u);
    EXPECT_NEAR(one.front().width, 20, 1e-6);
    const auto both = openings_of(holed_model({{65, 0}, {65, -15}, {35, -15}, {35, 0}},
                                              {{35, 0}, {35, 15}, {65, 15}, {65, 0}}));
    ASSERT_EQ(both.size(), 1u);
    EXPECT_NEAR(both.front().width, 30, 1e-6);
}

TEST(Openings, AreClosedHolesOfFiftyToAHundredMillimetresOutline) {
    // Rectangles and diamonds on both sides of the seam, less than 33.8 mm high.
    for (const double half : {4.0, 9.0, 16.0, 24.0})
        for (const double low : {3.0, 8.0, 14.0, 16.5})
            for (const bool diamond : {false, true}) {
                const double outline = diamond ? 4 * std::hypot(half, low) : 4 * half + 4 * low;
                if (outline < 50 || outline > 100) continue;
                const double right = 50 + half, left = 50 - half;
                std::vector<Vec2> lower{{right, 0}, {50, -low}, {left, 0}};
                if (!diamond) lower = {{right, 0}, {right, -low}, {left, -low}, {left, 0}};
                std::vector<Vec2> upper;
                for (auto p = lower.rbegin(); p != lower.rend(); ++p)
                    upper.emplace_back(p->x, -p->y);
                const auto found = openings_of(holed_model(lower, upper));
                ASSERT_EQ(found.size(), 1u) << half << ", " << low << ", " << diamond;
                const double tip = std::hypot(half, low);
                const double width = diamond ? 2 * half * low / tip : 2 * std::min(half, low);
                const double long_ = diamond ? 2 * std::max(half, low) * std::max(half, low) / tip
                                             : 2 * std::max(half, low);
                EXPECT_NEAR(found.front().width, width, 1e-6) << half << ", " << low;
                EXPECT_NEAR(found.front().length, long_, 1e-6) << half << ", " << low;
                EXPECT_LT((found.front().place - Vec3(50, 0, 0)).length(), 1e-6);
            }
}

TEST(Openings, AreClosedCutOutsOfUpToAHundredMillimetresWithAShortSide) {
    struct Cut {
        double half, low;
        bool is_listed;
    };
    for (const Cut& cut : {Cut{10, 20, true}, Cut{13, 23.5, true}, Cut{11.8, 26, true},
                           Cut{23, 3, true}, Cut{12.4, 25, false}, Cut{12.4, 25.1, false}}) {
        const double right = 50 + cut.half, left = 50 - cut.half;
        const auto found = openings_of(
            holed_model({{right, 0}, {right, -cut.low}, {left, -cut.low}, {left, 0}}, {}));
        ASSERT_EQ(found.size(), cut.is_listed ? 1u : 0u) << cut.half << ", " << cut.low;
        if (!cut.is_listed) continue;
        EXPECT_NEAR(found.front().width, std::min(2 * cut.half, cut.low), 1e-6);
        EXPECT_NEAR(found.front().length, std::max(2 * cut.half, cut.low), 1e-6);
        EXPECT_LT((found.front().place - Vec3(50, -cut.low / 2, 0)).length(), 1e-6);
    }
}

} // namespace
} // namespace keiko
