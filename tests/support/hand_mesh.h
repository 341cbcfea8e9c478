#pragma once

#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/scene/camera.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace keiko::test {

/// Adds a triangle with corners and normals of its own, of a face.
inline void add_triangle(SurfaceMesh& mesh, const std::array<Vec3, 3>& corners,
                         const std::array<Vec3, 3>& normals, std::uint32_t face = 1) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.normals.insert(mesh.normals.end(), normals.begin(), normals.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.faces.push_back(face);
}

/// A flat triangle.
inline void add_triangle(SurfaceMesh& mesh, const std::array<Vec3, 3>& corners,
                         std::uint32_t face = 1) {
    const Vec3 n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    add_triangle(mesh, corners, {n, n, n}, face);
}

/// A sphere about the origin in `n` x 2 n cells of two triangles, with its own normals; face 1.
inline SurfaceMesh sphere_mesh(double radius, int n) {
    SurfaceMesh mesh;
    const auto normal = [&](int i, int j) {
        const double polar = std::numbers::pi * i / n, around = std::numbers::pi * j / n;
        return Vec3(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                    std::cos(polar));
    };
    const auto add = [&](const std::array<Vec3, 3>& normals) {
        add_triangle(mesh, {normals[0] * radius, normals[1] * radius, normals[2] * radius},
                     normals);
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const Vec3 a = normal(i, j), b = normal(i + 1, j), c = normal(i + 1, j + 1),
                       d = normal(i, j + 1);
            if (i + 1 < n) add({a, b, c});
            if (i > 0) add({a, c, d});
        }
    return mesh;
}

/// A camera on the x axis towards the origin.
inline Camera camera_on_x(double distance, int width, int height,
                          Projection projection = Projection::perspective) {
    Camera camera;
    camera.projection = projection;
    camera.eye = Vec3(distance, 0, 0), camera.target = Vec3(0);
    camera.vertical_fov = 40, camera.orthographic_height = 0.7 * distance;
    camera.width = width, camera.height = height;
    return camera;
}

} // namespace keiko::test
