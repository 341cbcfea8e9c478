#pragma once

#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Triangles on the exact surfaces of a placed model. Neighbours on a face form an element. It has
/// two faces that exchange light: its front, where the corners run anticlockwise, and its back.
struct ElementMesh {
    SurfaceMesh mesh;                     ///< its faces are indices into SurfaceModel::faces
    std::vector<Vec2> uv;                 ///< a corner: its face parameters
    std::vector<std::uint32_t> instances; ///< a triangle: into SurfaceModel::instances
    std::vector<std::uint32_t> elements;  ///< a triangle: the number of its element, from 0

    /// Number of triangles.
    std::size_t size() const { return mesh.triangles.size(); }
    /// Corner 0, 1 or 2 of a triangle, world, mm.
    const Vec3& corner(std::size_t triangle, std::size_t which) const {
        return mesh.positions[mesh.triangles[triangle][which]];
    }
    /// Normal of the front, twice the area long.
    Vec3 normal(std::size_t triangle) const {
        const Vec3& a = corner(triangle, 0);
        return (corner(triangle, 1) - a).cross(corner(triangle, 2) - a);
    }
    /// Area of one face, mm2.
    double area(std::size_t triangle) const { return normal(triangle).length() / 2; }
    /// Centre of the triangle.
    Vec3 middle(std::size_t triangle) const {
        return (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3;
    }
    /// Length of the longest side, mm.
    double longest_side(std::size_t triangle) const;
};

} // namespace keiko
