#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/caustic_spec.h"
#include "keiko/scene/material.h"
#include "keiko/visibility/query/occluders.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

class ReflectedLight;
class SceneMaps;
class SceneTexels;
class SceneVolumes;

/// Scene of a picture; keeps references to everything.
struct PictureScene {
    const Tracer& tracer;                ///< built with second_derivatives
    std::span<const Material> materials; ///< one a face of the model
    const LightRig& rig;                 ///< lamps and medium
    Rgb background{0}; ///< cd/m2 behind the body, for camera rays; it is not reflected
    /// All of the model but glass, which dims light instead; without them nothing casts shadows.
    const Occluders* occluders = nullptr;
    const SceneMaps* maps = nullptr;       ///< of the materials, and the environment; null: none
    std::optional<CausticSpec> caustics{}; ///< none: mirrors and glass throw no light on surfaces
    const SceneVolumes* volumes = nullptr; ///< before and behind surfaces; not with a medium
    /// Light that surfaces reflect onto each other, in the place of the rig's ambient light; null:
    /// none.
    const ReflectedLight* reflected = nullptr;
    const SceneTexels* texels = nullptr; ///< over surfaces; null: none

    /// Tracer of what casts shadows.
    const Tracer& casting() const { return occluders ? occluders->tracer() : tracer; }
};

/// Options of a picture.
struct PictureOptions {
    std::vector<Aov> aovs{}; ///< layers besides the colour
    /// Largest number of cells a side into which a pixel with edges is divided; 1: one ray a pixel.
    int edge_samples = 8;
    /// Relative error allowed when direct diffuse light is interpolated between pixels; 0 computes
    /// it at every pixel. Under an open sky it may be three times as much of unshadowed light.
    double light_error = 2e-3;
    /// cd/m2 that will be shown as white. Darker light may then deviate by as much of a display
    /// level, by sRGB, as `light_error` is at white. Its share is 2.6 times as large at a tenth of
    /// white and 6.8 times at a hundredth. none: the same share everywhere.
    std::optional<double> white{};
    int max_depth = 3;        ///< mirror reflections followed along one ray, total ones aside
    int max_crossings = 12;   ///< interfaces of glass that light passes along one ray
    double min_weight = 1e-3; ///< rays with less weight than this end the path
    /// Model of tubes that light bases past occluders: picture; automatic, as for numbers; or
    /// preview, whose shadows disregard the width of lamps.
    TubeModel tubes = TubeModel::picture;
    /// Rays that gather the light of surfaces at each pixel; 0 interpolates it between the corners
    /// of elements.
    int gather_rays = 0;
};

/// Renders luminance in cd/m2 with the requested AOVs: one ray a pixel, whose footprint on the
/// C-plane gives smooth lamp stripes. Pixels near a silhouette, a trim border, a crease or the
/// border of a self-reflection of the body are split along it. Where it is not straight, they are
/// divided into up to `edge_samples`^2 cells. The same bytes for any thread count. Throws
/// Cancelled.
Film render(const PictureScene& scene, const Camera& camera, const PictureOptions& options,
            const Job& job = {});

} // namespace keiko
