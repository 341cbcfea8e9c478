#pragma once

#include "keiko/light/rig/luminance_along.h"
#include "keiko/render/shading/occluded_visibility.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Pencils of the point lights of a rig for the rays of a picture from one eye, by source; empty
/// where nothing casts shadows in a medium. Throws Cancelled.
std::vector<std::optional<EpipolarShadows>> shaft_pencils(const LightRig& rig,
                                                          const Occluders* occluders,
                                                          const Tracer& tracer, const Vec3& eye,
                                                          const Job& job = {});

/// What the lights of a rig see of some camera rays past the surfaces of a scene: where their
/// shafts in the medium are lit. What may stand in the way of a light is found once for all of the
/// rays.
class VolumetricShadows {
public:
    /// `camera_rays` hold every segment to come; neighbouring ones should stand together. Without
    /// occluders, or without a medium, nothing casts shadows. `pencils`: as shaft_pencils makes
    /// them, of the eye from which all of the rays come, each as far as the first surface; empty
    /// for any other rays. All but the rays are kept by reference. Not for two threads at once.
    VolumetricShadows(const LightRig& rig, const Occluders* occluders, const Tracer& tracer,
                      std::span<const Segment> camera_rays,
                      std::span<const std::optional<EpipolarShadows>> pencils = {});

    /// As luminance_along asks for it; refers to this object.
    VisibleFrom visible() const;

private:
    std::vector<OccludedVisibility> seen_; ///< by source; empty where nothing casts shadows
};

} // namespace keiko
