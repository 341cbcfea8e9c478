#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shading_rule.h"
#include "keiko/raster/shadow_casters.h"

#include <span>

namespace keiko {

/// Share of a light without extent that reaches the place in each pixel, one channel: 1 or 0. It is
/// 0 where nothing is seen, and where the facet's side that is seen faces away from the light.
/// `casters` are those of the view's own mesh, or of one that this begins with: the triangles that
/// follow receive shadows and cast none. The same for any number of threads. Throws
/// Cancelled.
Image lit_pixels(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                 MeshShadows by, const Job& job = {});

/// A point of a surface that emits light.
struct EmittingPoint {
    Vec3 position{0}; ///< world, mm
    Vec3 normal{0};   ///< unit, on the side that emits
    double area = 0;  ///< above 0: of the part of the surface that it stands for, in any unit
};

/// Share of the illuminance by an area light that reaches each pixel, from lights at many points
/// [Brotman1984]: 0 to 1, otherwise as lit_pixels(). Illuminance is that on the facets.
Image lit_pixels(const MeshView& view, const ShadowCasters& casters,
                 std::span<const EmittingPoint> points, MeshShadows by, const Job& job = {});

} // namespace keiko
