// Edges that faces share by the file while their borders are apart.
#include "keiko/inspect/openings/torn_edges.h"

#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Two flat sheets, 100 mm wide. The second begins at `from` and is `length` mm long along y.
test::ModelBuilder sheets(const Vec3& from, double length = 100) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.plane(from, {100, 0, 0}, {0, length, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    return builder;
}

/// The model with one edge for the right border of the first sheet and the left one of the second.
SurfaceModel sharing(const test::ModelBuilder& builder) {
    SurfaceModel model = builder.build();
    model.edges.push_back({1e-5, 2, false});
    model.trim_curves[1].edge = model.trim_curves[7].edge = 0;
    return model;
}

/// Findings of gaps at faces: those of seams have their seam.
std::vector<Check> torn(const Inspection& inspection) {
    std::vector<Check> found;
    for (const Check& finding : inspection.findings)
        if (finding.code == "G-SU-LG" && finding.seam == no_index) found.push_back(finding);
    return found;
}

TEST(TornEdges, AStepWiderThanTheJoinDistanceFails) {
    const Inspection inspection = inspect(sharing(sheets({100, 0, 3})));
    EXPECT_EQ(inspection.verdict, Verdict::fail);
    const std::vector<Check> found = torn(inspection);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].worst.value, 3, 1e-9);
    EXPECT_NEAR(found[0].worst.place.x, 100, 1e-9);
    EXPECT_NEAR(found[0].worst.place.z, 1.5, 1e-9);
    EXPECT_EQ(found[0].faces, "face 1 | face 2");
    EXPECT_NE(found[0].message.find("the file joins these faces there, but their borders are more "
                                    "than 0.5 mm apart for some 100 mm"),
              std::string::npos)
        << found[0].message;
    EXPECT_EQ(inspection.face_counts.fail, 1u);
}

TEST(TornEdges, AStepBetweenFacesThatShareNoEdgeDoesNot) {
    EXPECT_EQ(inspect(sheets({100, 0, 3}).build()).verdict, Verdict::pass);
}

TEST(TornEdges, AGapWithinTheJoinDistanceIsThatOfItsSeam) {
    const Inspection inspection = inspect(sharing(sheets({100.3, 0, 0})));
    EXPECT_EQ(inspection.verdict, Verdict::fail);
    EXPECT_TRUE(torn(inspection).empty());
}

TEST(TornEdges, FacesThatMeetHaveNone) {
    const Inspection inspection = inspect(sharing(sheets({100, 0, 0})));
    EXPECT_EQ(inspection.verdict, Verdict::pass);
}

TEST(TornEdges, ABorderThatEndsShortOfTheOtherFails) {
    const std::vector<Check> found = torn(inspect(sharing(sheets({100, 0, 0}, 92))));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LE(found[0].worst.value, 8);
    EXPECT_GT(found[0].worst.value, 7.8);
}

TEST(TornEdges, InstancesAreMeasuredAsTheyArePlaced) {
    test::ModelBuilder builder = sheets({100, 0, 0.4});
    builder.instance(Affine::scale(10));
    const std::vector<Check> found = torn(inspect(sharing(builder)));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].worst.value, 4, 1e-9);
}

/// A bent strip whose two ends are one edge, as of a closed surface that does not close.
TEST(TornEdges, OfAFaceWithItself) {
    test::ModelBuilder builder;
    builder.patch(3, 1,
                  {{0, 0, 0},
                   {0, 50, 0},
                   {90, 0, 0},
                   {90, 50, 0},
                   {-90, 0, 90},
                   {-90, 50, 90},
                   {0, 0, 4},
                   {0, 50, 4}});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    SurfaceModel model = builder.build();
    model.edges.push_back({1e-5, 2, false});
    model.trim_curves[1].edge = model.trim_curves[3].edge = 0;
    const std::vector<Check> found = torn(inspect(model));
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].worst.value, 4, 1e-9);
    EXPECT_EQ(found[0].faces, "face 1");
}

} // namespace
} // namespace keiko
