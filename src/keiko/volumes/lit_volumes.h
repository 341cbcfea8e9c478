#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/luminance/front_to_back.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/volumes/cloud_light.h"
#include "keiko/volumes/scene_volumes.h"

#include <optional>
#include <vector>

namespace keiko {

/// Volumes of a scene under a rig. Where they overlap, their optical depths add up, and each has
/// its share of the light.
class LitVolumes {
public:
    /// Finds the light on clouds, which the surfaces of `stops` hide. Keeps a reference to the
    /// volumes. Throws Cancelled.
    LitVolumes(const SceneVolumes& volumes, const LightRig& rig, const StopOfLight& stops = {},
               const Job& job = {});

    /// Light of the volumes towards the begin of a segment, cd/m2, and their opacity along it. It
    /// ends early where less than a thousandth of the light behind passes.
    FrontToBack along(const Segment& segment) const;

private:
    const SceneVolumes& volumes_;
    std::vector<std::optional<CloudLight>> clouds_; ///< by volume; none: not lit by sun and sky
};

} // namespace keiko
