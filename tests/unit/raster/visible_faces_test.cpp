#include "keiko/geometry/model/patch_grid.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/patch_subdivision.h"
#include "keiko/raster/span_mesh.h"

#include "tests/support/hand_mesh.h"
#include "tests/support/picture_interior.h"
#include "tests/support/shapes.h"
#include "tests/support/traced_faces.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr double deviation = 0.3, floor_z = -12;
constexpr std::array every_algorithm{HiddenSurfaces::z_buffer, HiddenSurfaces::scan_line,
                                     HiddenSurfaces::painter};

struct Ball {
    Vec3 center;
    double radius;
};
const std::array balls{Ball{Vec3(0), 30}, Ball{Vec3(20, 18, 6), 25}};

/// Balls that pierce each other and a floor, which reaches behind the eye.
SurfaceModel pierced_model() {
    test::ShapeBuilder shape;
    for (const Ball& ball : balls) shape.face(test::sphere(ball.center, ball.radius));
    shape.face({test::rectangle(-500, 500, -500, 500, floor_z)});
    return shape.model();
}

SurfaceMesh mesh_of(const SurfaceModel& model) {
    SurfaceMesh mesh;
    const ModelMesh faces = span_mesh(model, deviation);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const PatchGrid grid(model, model.faces[f]);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec2& uv : faces[f].uv) {
            const auto [patch, own] = place_at(model, grid, uv);
            mesh.positions.push_back(evaluate(model.patch(patch), own, 0).position());
            mesh.normals.emplace_back(0);
        }
        for (const auto& [a, b, c] : faces[f].triangles) {
            mesh.triangles.push_back({first + a, first + b, first + c});
            mesh.faces.push_back(f);
        }
    }
    return mesh;
}

ItemBuffer faces_of(const MeshView& view) {
    ItemBuffer faces(view.items().width, view.items().height);
    for (std::size_t i = 0; i < faces.shown.size(); ++i)
        if (view.items().shown[i] != no_index)
            faces.shown[i] = view.mesh().faces[view.items().shown[i]];
    return faces;
}

/// mm of a place from the surface of a face.
double off_surface(const Vec3& place, std::uint32_t face) {
    if (face >= balls.size()) return std::abs(place.z - floor_z);
    return std::abs((place - balls[face].center).length() - balls[face].radius);
}

double most_off_surface(const MeshView& view) {
    double most = 0;
    for (int y = 0; y < view.items().height; ++y)
        for (int x = 0; x < view.items().width; ++x)
            if (const auto place = view.at(x, y))
                most = std::max(most,
                                off_surface(place->position, view.mesh().faces[place->triangle]));
    return most;
}

TEST(VisibleFaces, AreThoseOfTheTracerByEveryAlgorithm) {
    const SurfaceModel model = pierced_model();
    const SurfaceMesh mesh = mesh_of(model);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Camera camera = test::camera_on_x(100, 120, 90, projection);
        camera.eye = Vec3(100, 15, 30);
        const ItemBuffer truth = test::traced_faces(model, camera);
        for (const std::uint32_t face : {0U, 1U, 2U})
            EXPECT_GT(std::count(truth.shown.begin(), truth.shown.end(), face), 300) << face;
        for (const HiddenSurfaces by : every_algorithm) {
            const MeshView view(mesh, camera, {}, by);
            EXPECT_EQ(test::wrong_inside(truth, faces_of(view)), 0) << static_cast<int>(by);
            EXPECT_LE(most_off_surface(view), deviation + 1e-9);
            EXPECT_GT(most_off_surface(view), deviation / 20);
        }
        EXPECT_EQ(test::wrong_inside(truth, subdivided_faces(model, camera)), 0);
    }
}

} // namespace
} // namespace keiko
