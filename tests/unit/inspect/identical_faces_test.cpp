#include "keiko/inspect/overlaps/identical_faces.h"

#include "keiko/inspect/inspection.h"
#include "keiko/inspect/overlaps/identical_edges.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace keiko {
namespace {

constexpr double limit = 0.02; // mm

CriteriaPreset preset_of_identical() {
    CriteriaPreset preset;
    preset.structure.identical_face = preset.structure.identical_edge = limit;
    return preset;
}

std::vector<IdenticalFaces> identical(const SurfaceModel& model) {
    return identical_faces(model, preset_of_identical());
}

/// Two rectangles: one of 100 x 60 mm, and one from `origin` along x and y.
SurfaceModel rectangles(const Vec3& origin, double length, double width) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), {100, 0, 0}, {0, 60, 0});
    builder.plane(origin, {0, width, 0}, {length, 0, 0});
    return builder.build();
}

TEST(IdenticalFaces, FindsAFaceThatIsThereTwice) {
    const auto pairs = identical(rectangles(Vec3(0), 100, 60));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_TRUE(pairs[0].mutual);
    EXPECT_TRUE(pairs[0].deep);
    EXPECT_NEAR(pairs[0].distance, 0, 1e-9);
}

TEST(IdenticalFaces, MeasuresTheDistanceAgainstTheLimit) {
    const auto near = identical(rectangles({0, 0, 0.019}, 100, 60));
    ASSERT_EQ(near.size(), 1U);
    EXPECT_NEAR(near[0].distance, 0.019, 1e-9);
    EXPECT_TRUE(identical(rectangles({0, 0, 0.021}, 100, 60)).empty());
    EXPECT_TRUE(identical(rectangles({0.03, 0, 0}, 100, 60)).empty());
}

TEST(IdenticalFaces, FindsAFaceThatLiesOnALargerOne) {
    const auto pairs = identical(rectangles({20, 20, 0}, 30, 10));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_FALSE(pairs[0].mutual);
    EXPECT_EQ(pairs[0].faces[0].face, 1U);
    EXPECT_EQ(pairs[0].faces[1].face, 0U);
}

TEST(IdenticalFaces, LeavesNeighboursAlone) {
    EXPECT_TRUE(identical(rectangles({100, 0, 0}, 50, 60)).empty());
    EXPECT_TRUE(identical(rectangles({20, 60, 0}, 50, 60)).empty());
}

/// A face that lies in the hole of another has its borders on it, and nothing else.
TEST(IdenticalFaces, LeavesAFaceInTheHoleOfAnotherAlone) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), {100, 0, 0}, {0, 60, 0});
    builder.polygon({Vec2(0), Vec2(1, 0), Vec2(1), Vec2(0, 1)});
    builder.polygon({Vec2(0.2), Vec2(0.2, 0.4), Vec2(0.4), Vec2(0.4, 0.2)});
    builder.plane({20, 12, 0}, {20, 0, 0}, {0, 12, 0});
    EXPECT_TRUE(identical(builder.build()).empty());
}

/// All of a sliver is within the limit of its neighbour's border: nothing tells them apart.
TEST(IdenticalFaces, DoesNotDecideOnASliver) {
    const auto pairs = identical(rectangles({100, 0, 0}, 0.015, 60));
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_FALSE(pairs[0].deep);
    EXPECT_TRUE(identical(rectangles({100, 0, 0}, 0.05, 60)).empty());
}

/// The points of a bicubic net; `u` and `v` reversed or swapped.
std::vector<Vec3> net(const std::vector<Vec3>& points, bool reversed, bool swapped) {
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const std::size_t u = reversed ? 3 - i : i;
            result.push_back(swapped ? points[j * 4 + u] : points[u * 4 + j]);
        }
    return result;
}

/// Bicubic panels, each again in other parameters and moved along its normal, or askew.
TEST(IdenticalFaces, FindsPlantedTwinsAmongRandomPanels) {
    test::Random random(5);
    for (int k = 0; k < 30; ++k) {
        std::vector<Vec3> points;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                points.emplace_back(i * 30, j * 20, test::uniform(random, -15, 15));
        const bool twin = k % 2 == 0;
        const double off =
            twin ? test::uniform(random, 0, 0.95) * limit : test::uniform(random, 1.3, 9) * limit;
        const Vec3 way = twin ? test::random_direction(random) : Vec3(0, 0, 1);
        std::vector<Vec3> moved =
            net(points, test::pick(random, 2) == 1, test::pick(random, 2) == 1);
        for (Vec3& p : moved) p += way * off;
        test::ModelBuilder builder;
        builder.patch(3, 3, points);
        builder.patch(3, 3, moved);
        const auto pairs = identical(builder.build());
        EXPECT_EQ(pairs.size(), twin ? 1U : 0U) << k << " off by " << off;
        if (!pairs.empty()) {
            EXPECT_LE(pairs[0].distance, off + 1e-9);
        }
    }
}

TEST(IdenticalFaces, AreFindingsOfTheFirstFace) {
    const Inspection inspection = inspect(rectangles({0, 0, 0.01}, 100, 60), preset_of_identical());
    const auto found = std::find_if(inspection.findings.begin(), inspection.findings.end(),
                                    [](const Check& check) { return check.code == "G-SU-EM"; });
    ASSERT_NE(found, inspection.findings.end());
    EXPECT_EQ(found->rule, "multiply_defined_faces");
    EXPECT_EQ(found->message,
              "the distance from another face of 0.01 mm is under the limit of "
              "0.02 mm; face 2 is the same surface");
}

/// Two squares of 10 mm side by side, and the second one again. `edges`: of their curves, four a
/// face, from v = 0 anticlockwise.
SurfaceModel squares(const std::vector<std::uint32_t>& edges) {
    test::ModelBuilder builder;
    for (const double x : {0.0, 10.0, 10.0}) {
        builder.plane({x, 0, 0}, {10, 0, 0}, {0, 10, 0});
        builder.polygon({Vec2(0), Vec2(1, 0), Vec2(1), Vec2(0, 1)});
    }
    SurfaceModel model = builder.build();
    model.edges.resize(12);
    for (std::size_t i = 0; i < edges.size(); ++i) model.trim_curves[i].edge = edges[i];
    return model;
}

std::vector<IdenticalEdges> pairs_of(const SurfaceModel& model) {
    return identical_edges(model, preset_of_identical());
}

/// Face 3 stands on the seam of the other two with an edge of its own.
TEST(IdenticalEdges, FindsAnEdgeBesideASharedOne) {
    SurfaceModel model = squares({0, 1, 2, 3, 4, 5, 6, 1, 7, 8, 9, 10});
    // Turned up about its side x = 10.
    for (std::size_t i = 8; i < 12; ++i) {
        Vec4& p = model.control_points[i];
        p = Vec4(10, p.y, p.x - 10, 1);
    }
    const auto pairs = pairs_of(model);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_NEAR(pairs[0].distance, 0, 1e-12);
    EXPECT_NEAR(pairs[0].length, 10, 1e-9);
    EXPECT_NEAR(pairs[0].place.x, 10, 1e-9);
}

TEST(IdenticalEdges, LeavesSeamsAloneThatTheFileDoesNotJoin) {
    SurfaceModel model = squares({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    for (std::size_t i = 8; i < 12; ++i) model.control_points[i].z += 50;
    EXPECT_TRUE(pairs_of(model).empty());
}

TEST(IdenticalEdges, LeavesJoinedSeamsAlone) {
    SurfaceModel model = squares({0, 1, 2, 3, 4, 5, 6, 1, 7, 8, 9, 10});
    for (std::size_t i = 8; i < 12; ++i) model.control_points[i].z += 50;
    EXPECT_TRUE(pairs_of(model).empty());
}

} // namespace
} // namespace keiko
