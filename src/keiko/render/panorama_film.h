#pragma once

#include "keiko/base/export.h"
#include "keiko/render/shading/picture.h"
#include "keiko/scene/environment_spec.h"

namespace KEIKO_API keiko {

/// Panorama of a scene.
struct PanoramaView {
    Vec3 eye{0}; ///< mm, from where the scene is seen
    EnvironmentSpec::Layout layout = EnvironmentSpec::Layout::lat_long; ///< of the picture
    /// Pixels, 2 or more: of a row of the picture, twice its height, or of the side of a square.
    int width = 1024;
};

/// Renders what mirrors at a place see in all directions, cd/m2, for use as an environment: rows of
/// tubes and ambient light included. One ray a pixel; lamps are integrated over it, edges of bodies
/// are not. The same bytes for any thread count. Throws Cancelled.
Film render_panorama(const PictureScene& scene, const PanoramaView& view,
                     const PictureOptions& options, const Job& job = {});

} // namespace keiko
