#pragma once

#include "keiko/light/rig/luminance_along.h"
#include "keiko/render/shading/occluded_visibility.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Pencils of the point lights of a rig for the rays of a picture from one viewpoint, by source;
/// empty if nothing casts shadows in a medium. Throws Cancelled.
std::vector<std::optional<EpipolarShadows>> shaft_pencils(const LightRig& rig,
                                                          const Occluders* occluders,
                                                          const Tracer& tracer, const Vec3& eye,
                                                          const Job& job = {});

/// Visibility of camera rays from the lights of a rig past the surfaces of a scene: the lit parts
/// of their shafts in the medium. Possible occluders of a light are found once for all of the rays.
class VolumetricShadows {
public:
    /// `camera_rays` contain every segment to come; neighbouring ones should be adjacent. Without
    /// occluders, or without a medium, no shadows are cast. `pencils` are those of shaft_pencils,
    /// for the viewpoint of all of the rays, each ray up to the first surface; empty for any other
    /// rays. References are kept to everything except the rays. Not for two threads at once.
    VolumetricShadows(const LightRig& rig, const Occluders* occluders, const Tracer& tracer,
                      std::span<const Segment> camera_rays,
                      std::span<const std::optional<EpipolarShadows>> pencils = {});

    /// Visibility function for luminance_along; refers to this object.
    VisibleFrom visible() const;

private:
    std::vector<OccludedVisibility> seen_; ///< by source; empty if nothing casts shadows
};

} // namespace keiko
