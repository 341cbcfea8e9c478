#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/light/rig/rig_planes.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/reflection_error.h"
#include "keiko/scene/camera.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Mirror before rows of lamps at the centre of a pixel.
struct MirrorPixel {
    std::uint32_t face = 0; ///< number of the face; 0: none
    MetSurface met{};       ///< by the camera ray, whose direction is unit
    double coverage = 0;    ///< share of the pixel that mirrored lamps fill, 0 to 1
    double distance = 0;    ///< mm along the mirrored ray to a row of lamps; 0: it meets none
    double footprint = 0;   ///< mm, edge of the pixel's image there; 0 where it is not known
};

/// True for pixels whose mirrored lamps can be compared: both show one face, and at least one of
/// them meets a row of lamps or mirrors a part of a lamp.
inline bool is_compared(const MirrorPixel& truth, const MirrorPixel& mesh) {
    const auto mirrors = [](const MirrorPixel& pixel) {
        return pixel.distance > 0 || pixel.coverage > 0;
    };
    return truth.face != 0 && truth.face == mesh.face && (mirrors(truth) || mirrors(mesh));
}

/// A surface as a mirror of the lamps alone: it mirrors neither itself nor what else there is.
struct MirrorPicture {
    int width = 0, height = 0;       ///< pixels
    std::vector<MirrorPixel> pixels; ///< row by row

    /// A pixel, from the upper left.
    const MirrorPixel& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// The exact surface of a model. The tracer is of this model, with second derivatives. Throws
/// Cancelled.
MirrorPicture mirror_picture(const Tracer& tracer, const SurfaceModel& model, const Camera& camera,
                             const RigPlanes& lamps, const Job& job = {});

/// A mesh under the mixed normals of its corners. Throws Cancelled.
MirrorPicture mirror_picture(const MeshView& view, const RigPlanes& lamps, const Job& job = {});

} // namespace keiko
