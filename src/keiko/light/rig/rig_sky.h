#pragma once

#include "keiko/light/areas/area_coverage.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/light/rig/rig_planes.h"
#include "keiko/math/ray_differentials.h"

#include <optional>
#include <vector>

namespace keiko {

/// The sky of a rig, prepared for camera rays and reflected rays.
class RigSky {
public:
    /// A copy of all that is read of the rig is kept.
    explicit RigSky(const LightRig& rig);

    /// True if the rig has none.
    bool empty() const { return !sky_; }
    /// Sky and ground beyond everything else on a ray, over the footprint of its pixel if there is
    /// a `spread`: the mean at the horizon and at the sides of windows. With windows only these are
    /// covered.
    MirroredLight beyond(const Vec3& origin, const Vec3& direction,
                         const std::optional<RayDifferentials>& spread) const;

private:
    Rgb luminance(const Vec3& direction, const std::optional<RayDifferentials>& spread) const;

    std::optional<SkyLight> sky_;
    std::vector<PanelOutline> windows_; ///< of the sky
};

} // namespace keiko
