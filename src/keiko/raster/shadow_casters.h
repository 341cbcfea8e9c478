#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/geometry/rays/ray.h"

#include <array>
#include <cstdint>

namespace keiko {

/// The triangles of a mesh in a tree, for what lies in the way of light.
class ShadowCasters {
public:
    /// Keeps a reference to the mesh.
    explicit ShadowCasters(const SurfaceMesh& mesh);

    /// The mesh that casts shadows.
    const SurfaceMesh& mesh() const { return mesh_; }
    /// The boxes of its triangles.
    const BoxTree& tree() const { return tree_; }
    /// Box around all of it, world, mm.
    const Box3& bounds() const { return bounds_; }
    /// mm within which places count as one: far above rounding.
    double rounding() const { return rounding_; }
    /// Corners of a triangle, world, mm.
    std::array<Vec3, 3> corners(std::uint32_t triangle) const;

    /// True if a light at a point lies in the plane of a triangle, within rounding. The triangle
    /// casts no shadow then: it is seen edge on, or the light is flush with it.
    bool hold(std::uint32_t triangle, const Viewpoint& light) const;
    /// True if a triangle other than `except` shades a place.
    bool hide(const Vec3& place, const Viewpoint& light, std::uint32_t except) const;
    /// Number of the triangles that shade a place.
    int layers(const Vec3& place, const Viewpoint& light) const;

private:
    /// Calls `visit` with the triangles between both that do not hold the light until it returns
    /// true.
    template <class Visit>
    bool any_between(const Vec3& place, const Viewpoint& light, const Visit& visit) const;

    const SurfaceMesh& mesh_;
    Box3 bounds_;
    double rounding_;
    BoxTree tree_;
};

} // namespace keiko
