#pragma once

#include "keiko/base/job.h"
#include "keiko/light/rig/light_rig.h"
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
/// how deep in the volumes of the scene the nodes of a coarser grid lie, as seen from each light.
/// The second sums up along camera rays (docs/theory/volumes.md#clouds).
class CloudLight {
public:
    /// First pass for one of the volumes of a scene, with `scattering`, to which it keeps a
    /// reference. Throws Cancelled.
    CloudLight(const SceneVolumes& scene, const Volume& volume, const LightRig& rig,
               const Job& job);

    /// cd/m2 that an opaque layer at a place of the volume's grid scatters to the viewer.
    Rgb luminance(const Vec3& place, const Vec3& to_viewer) const;

private:
    /// A light, and how deep the nodes of a grid that fills the volume lie in it.
    struct Beam {
        ParallelLight light;
        std::array<int, 3> nodes;    ///< of this grid
        Vec3 steps{1};               ///< of the volume's grid between two of its nodes
        std::vector<float> depths{}; ///< optical depths, x fastest
    };

    /// Beam with a grid of about `most` nodes at most.
    Beam beam(const SceneVolumes& scene, const ParallelLight& light, double most,
              const Job& job) const;
    /// Optical depth between a place in the scene and a light.
    double depth(const SceneVolumes& scene, const Vec3& place, const Vec3& towards) const;

    const Volume& volume_;
    double mean_extinction_; ///< 1/mm, of the volume's nodes
    std::vector<Beam> beams_;
};

} // namespace keiko
