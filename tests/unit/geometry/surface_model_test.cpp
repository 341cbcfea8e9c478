#include "keiko/geometry/model/surface_model.h"

#include <gtest/gtest.h>

using namespace keiko;

namespace {

/// Two bilinear faces, the second trimmed by a triangle, placed twice.
SurfaceModel two_faces(double z) {
    SurfaceModel model;
    model.source = "z" + std::to_string(static_cast<int>(z));
    model.format = "BPT";
    for (std::uint32_t f = 0; f < 2; ++f) {
        for (const double x : {0.0, 1.0})
            for (const double y : {0.0, 1.0}) model.control_points.emplace_back(x + f, y, z, 1);
        model.patches.push_back({f, 4 * f, 1, 1, {}, {ParameterMap::Kind::affine, 2, 4}});
        Face face;
        face.id = f + 1;
        face.first_patch = f;
        face.patch_count = 1;
        model.faces.push_back(face);
    }
    model.trim_points = {{0, 2, 1}, {1, 2, 1}, {1, 2, 1}, {0, 4, 1}, {0, 4, 1}, {0, 2, 1}};
    model.trim_curves = {{0, 1, 0}, {2, 1, no_index}, {4, 1, no_index}};
    model.trim_loops = {{0, 3}};
    model.faces[1].loop_count = 1;
    model.edges = {{0.001, 1, false}};
    model.parts = {{"panel", 0, 2}};
    model.instances = {{0, "left", {}}, {0, "right", Affine::translate({0, 10, 0})}};
    return model;
}

} // namespace

TEST(SurfaceModel, ViewsFindTheirPoints) {
    const SurfaceModel model = two_faces(5);
    EXPECT_EQ(model.patch(1).point(1, 0), Vec4(2, 0, 5, 1));
    EXPECT_EQ(model.face_parameters(1, {0.5, 0.5}), Vec2(0.5, 3));
    ASSERT_EQ(model.loops_of(model.faces[1]).size(), 1u);
    EXPECT_EQ(model.curves_of(model.loops_of(model.faces[1])[0]).size(), 3u);
    EXPECT_EQ(model.trim_curve(1).points[1], Vec3(0, 4, 1));
}

TEST(SurfaceModel, BoundsCoverEveryInstance) {
    EXPECT_EQ(hull_bounds(two_faces(5)), (Box3{{0, 0, 5}, {2, 11, 5}}));
}

TEST(SurfaceModel, MergedModelsKeepTheirGeometryAndGetUniqueIds) {
    const std::vector<SurfaceModel> models{two_faces(5), two_faces(-3)};
    const SurfaceModel all = merge(models);
    ASSERT_EQ(all.faces.size(), 4u);
    for (std::uint32_t f = 0; f < 4; ++f) EXPECT_EQ(all.faces[f].id, f + 1);
    EXPECT_EQ(all.patches[3].face, 3u);
    EXPECT_EQ(all.patch(3).point(0, 0), Vec4(1, 0, -3, 1));
    EXPECT_EQ(all
                  .trim_curve(static_cast<std::uint32_t>(
                      all.curves_of(all.loops_of(all.faces[3])[0]).data() - all.trim_curves.data()))
                  .points[0],
              Vec3(0, 2, 1));
    EXPECT_EQ(all.trim_curves[3].edge, 1u);
    EXPECT_EQ(all.trim_curves[4].edge, no_index);
    EXPECT_EQ(all.instances[2].part, 1u);
    EXPECT_EQ(hull_bounds(all), (Box3{{0, 0, -3}, {2, 11, 5}}));
    EXPECT_EQ(all.source, "z5, z-3");
    EXPECT_EQ(files_of(all), (std::vector<std::string>{"z5", "z-3"}));
    for (std::uint32_t f = 0; f < 4; ++f) EXPECT_EQ(all.faces[f].file, f / 2);
    const std::vector<SurfaceModel> more{two_faces(1), all};
    EXPECT_EQ(merge(more).faces[5].file, 2u);
    EXPECT_EQ(files_of(merge(more)).size(), 3u);
}
