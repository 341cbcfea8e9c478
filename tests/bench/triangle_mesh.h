#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace keiko::bench {

/// Triangles in the form that Embree takes, relative to a centre, with unit normals at the
/// vertices. One position more than there are normals closes the list: Embree reads beyond the
/// last vertex.
struct TriangleMesh {
    std::vector<Imath::V3f> positions, normals;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    double mesh_seconds = 0; ///< processor time of the tessellation, normals not counted
    /// mm between the surface and its triangles at their middles, p99.9: what a requested
    /// deflection became.
    double deviation = 0;
    std::size_t faces_without = 0; ///< faces that no triangle came out of

    std::size_t bytes() const {
        return (positions.size() + normals.size()) * sizeof(Imath::V3f) +
               triangles.size() * sizeof(triangles[0]);
    }
    /// Interpolated over a triangle, unit.
    Vec3 normal(std::uint32_t triangle, float u, float v) const {
        const auto& [a, b, c] = triangles[triangle];
        const Vec3 n = Vec3(normals[a]) * (1.0 - static_cast<double>(u) - static_cast<double>(v)) +
                       Vec3(normals[b]) * static_cast<double>(u) +
                       Vec3(normals[c]) * static_cast<double>(v);
        return n.normalized();
    }
};

} // namespace keiko::bench
