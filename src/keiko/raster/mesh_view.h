#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/raster/shading_rule.h"
#include "keiko/scene/camera.h"

#include <array>
#include <cstdint>
#include <optional>

namespace keiko {

/// Place of a triangle.
struct MeshPlace {
    std::uint32_t triangle = 0; ///< into SurfaceMesh::triangles
    Vec3 weights{0};            ///< shares of its corners, 0 to 1, see weights_within()
    Vec3 position{0};           ///< world, mm
    Vec3 normal{0};             ///< unit, of either side: those of the corners, mixed by Phong
};

/// A mesh as a camera sees it: what viewports show of a surface.
class MeshView {
public:
    /// Finds the triangle of each pixel. Keeps references to the mesh and the camera. Throws
    /// Cancelled.
    MeshView(const SurfaceMesh& mesh, const Camera& camera, const Job& job = {},
             HiddenSurfaces by = HiddenSurfaces::z_buffer);

    /// A view whose pixels are known to show these triangles. Keeps the same references.
    MeshView(const SurfaceMesh& mesh, const Camera& camera, ItemBuffer items);

    /// The mesh that is seen.
    const SurfaceMesh& mesh() const { return mesh_; }
    /// The eye.
    const Camera& camera() const { return camera_; }
    /// The triangle of each pixel.
    const ItemBuffer& items() const { return items_; }

    /// The place at the centre of a pixel; nullopt where it shows none.
    std::optional<MeshPlace> at(int x, int y) const;
    /// The ray that the place at a pixel's centre mirrors, with differentials by central
    /// differences on its triangle. The direction is unit.
    Ray mirrored(int x, int y, const MeshPlace& place) const;

    /// Corners of a triangle, world, mm.
    std::array<Vec3, 3> corners(std::uint32_t triangle) const;
    /// Unit normal of a triangle's plane; 0 for one without area.
    Vec3 facet_normal(std::uint32_t triangle) const;
    /// Unit normals at the corners of a triangle: those of the surface, or else its own.
    std::array<Vec3, 3> corner_normals(std::uint32_t triangle) const;

private:
    MeshPlace place(std::uint32_t triangle, const Vec3& weights) const;
    /// The ray mirrored by the triangle's plane, beside the triangle too.
    Ray mirrored_at(const Vec2& pixel, std::uint32_t triangle) const;

    const SurfaceMesh& mesh_;
    const Camera& camera_;
    PreparedCamera prepared_;
    ItemBuffer items_;
};

} // namespace keiko
