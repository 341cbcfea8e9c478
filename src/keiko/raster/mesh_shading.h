#pragma once

#include "keiko/film/film.h"
#include "keiko/math/rgb.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shading_rule.h"

#include <functional>

namespace keiko {

/// Place of a mesh whose luminance is wanted.
struct ShadedPlace {
    MeshPlace place; ///< its normal on the side of the eye
    Vec3 eye{0};     ///< unit, towards the eye
    Ray mirrored{};  ///< what it mirrors to the eye; with differentials for pixels
};

/// Luminance that a place sends to the eye, cd/m2. Several threads call it at once.
using PlaceLight = std::function<Rgb(const ShadedPlace&)>;

/// The luminance of a mesh, cd/m2, 3 channels; black where nothing is seen. The same for any number
/// of threads. Throws Cancelled.
Image shaded_mesh(const MeshView& view, MeshShading shading, const PlaceLight& light,
                  const Job& job = {});

} // namespace keiko
