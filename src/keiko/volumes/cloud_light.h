#pragma once

#include "keiko/base/job.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/math/trilinear.h"
#include "keiko/volumes/beam_depths.h"
#include "keiko/volumes/scene_volumes.h"
#include "keiko/volumes/volume.h"

#include <array>
#include <vector>

namespace keiko {

/// Light from one direction, parallel.
struct ParallelLight {
    Vec3 towards{0, 0, 1}; ///< unit, to where it comes from
    Rgb illuminance;       ///< lx on a surface across it
};

/// Parallel lights that stand for the suns without windows of a rig, in their order, and then for
/// its skies without windows and its ambient light, by nodes of a quadrature over all directions.
struct DistantLights {
    std::vector<ParallelLight> suns, surroundings;
};
/// Distant lights of a rig.
DistantLights distant_lights(const LightRig& rig);

/// Light of sun, sky and ambient light that a volume scatters once, in two passes. The first finds
/// how deep in the volumes of the scene its places lie, as seen from each light. The second sums
/// up along camera rays, by a CloudView each (docs/theory/volumes.md#clouds).
class CloudLight {
public:
    /// First pass for one of the volumes of a scene, with `scattering`, to which it keeps a
    /// reference. `stops`: the surfaces of the scene. Throws Cancelled.
    CloudLight(const SceneVolumes& scene, const Volume& volume, const LightRig& rig,
               const StopOfLight& stops, const Job& job);

private:
    friend class CloudView;

    /// Depths towards a light.
    BeamDepths depths_towards(const SceneVolumes& scene, const ParallelLight& light, double most,
                              const StopOfLight& stops, const Job& job) const;
    void find_surroundings(const SceneVolumes& scene, const StopOfLight& stops, const Job& job);

    const Volume& volume_;
    double mean_extinction_; ///< 1/mm, of the volume's nodes
    std::vector<ParallelLight> suns_, surroundings_;
    std::vector<BeamDepths> sun_depths_;
    std::array<int, 3> nodes_{2, 2, 2}; ///< of a grid that fills the volume, for the surroundings
    Vec3 steps_{1};                     ///< of the volume's grid between two of its nodes
    std::vector<float> passed_; ///< share of each of the surroundings that reaches each node
};

/// The light of a cloud for one viewer at infinity. It keeps the sums at the nodes around the last
/// place, so places should follow a ray. Not for two threads at once.
class CloudView {
public:
    /// Keeps a reference to the light. `to_viewer`: unit.
    CloudView(const CloudLight& light, const Vec3& to_viewer);

    /// cd/m2 that an opaque layer at a place of the volume's grid scatters to the viewer.
    Rgb luminance(const Vec3& place);

private:
    void sum_surroundings(const GridCell& cell);

    const CloudLight* light_;
    std::vector<Rgb> of_suns_, of_surroundings_; ///< cd/m2, where nothing dims them
    std::array<std::size_t, 3> cell_;            ///< whose corners were summed up last
    std::array<Vec3, 8> logarithms_;             ///< of the sums at the corners, x fastest
};

} // namespace keiko
