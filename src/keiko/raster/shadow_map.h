#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shadow_casters.h"

#include <optional>
#include <vector>

namespace keiko {

/// Picture of a mesh from a light without extent: the first stage of shadows in two
/// [Williams1978].
class ShadowMap {
public:
    /// `size`: pixels a side, up to 16384. Keeps a reference to the mesh. Throws Cancelled.
    ShadowMap(const ShadowCasters& casters, const Viewpoint& light, int size, const Job& job = {});

    /// True if the light sees a place of a triangle: the map shows that triangle there, or one
    /// whose plane the place is not behind by more than a pixel of the map is wide.
    bool sees(const Vec3& place, std::uint32_t triangle) const;

    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

private:
    Viewpoint light_;
    std::vector<Camera> cameras_;    ///< one towards all of the mesh, or six all around
    std::optional<SurfaceMesh> own_; ///< what casts shadows, if that is not all of the mesh
    std::vector<MeshView> views_;    ///< keep references to the members above
};

/// lit_pixels() by a map of that many pixels a side.
Image lit_by_map(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                 const Job& job = {}, int size = 2048);

} // namespace keiko
