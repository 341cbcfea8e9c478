#pragma once

#include "tests/support/hand_mesh.h"

namespace keiko::test {

/// Scene of sphere_and_plate().
constexpr double sphere_radius = 30, floor_z = -45, plate_z = -38; // mm

/// A rectangle across z in two triangles; upwards.
inline void add_plate(SurfaceMesh& mesh, const Vec2& low, const Vec2& high, double z) {
    add_triangle(mesh, {Vec3(low.x, low.y, z), Vec3(high.x, low.y, z), Vec3(high.x, high.y, z)});
    add_triangle(mesh, {Vec3(low.x, low.y, z), Vec3(high.x, high.y, z), Vec3(low.x, high.y, z)});
}

/// A sphere about the origin and a plate over a floor.
inline SurfaceMesh sphere_and_plate(int cells) {
    SurfaceMesh mesh = sphere_mesh(sphere_radius, cells);
    add_plate(mesh, Vec2(-300), Vec2(300), floor_z);
    add_plate(mesh, Vec2(40, -20), Vec2(70, 20), plate_z);
    return mesh;
}

/// A camera above both.
inline Camera camera_above(Projection projection = Projection::perspective) {
    Camera camera = camera_on_x(260, 100, 80, projection);
    camera.eye = Vec3(170, 120, 130), camera.target = Vec3(10, 0, -30);
    return camera;
}

} // namespace keiko::test
