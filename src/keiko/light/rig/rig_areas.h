#pragma once

#include "keiko/light/areas/area_coverage.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/math/bounds.h"
#include "keiko/math/ray_differentials.h"

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace keiko {

/// The panels, spheres and curved lights of a rig, prepared for camera rays and reflected rays.
class RigAreas {
public:
    /// An area light along a ray.
    struct Layer {
        /// Its distance, and the share, 0 to 1, that it fills of what nearer ones leave of the
        /// pixel. Lights that meet at an edge there fill their parts side by side.
        AreaHit hit;
        Rgb luminance;        ///< cd/m2
        std::size_t area = 0; ///< the light, into boxes() and places()
    };

    /// A copy of all that is read of the rig is kept.
    explicit RigAreas(const LightRig& rig);

    /// True if the rig has none.
    bool empty() const { return areas_.empty(); }
    /// Lights that a ray meets with t up to `t_max`, over the footprint of its pixel if there is a
    /// `spread`; the nearest first.
    std::vector<Layer> along(const Vec3& origin, const Vec3& direction,
                             const std::optional<RayDifferentials>& spread, double t_max) const;
    /// A box around each.
    std::vector<Box3> boxes() const;
    /// Places of each: of a panel the middle of its corners, or, if it is beside the panel, the
    /// middles of three corners in a row, some of them on it. Of another the middle of its box.
    std::vector<std::vector<Vec3>> places() const;

private:
    /// An area light, prepared for rays.
    struct Area {
        std::variant<PanelOutline, SphereLight, DiscLight, FrustumLight, EllipsoidLight> shape;
        Rgb luminance; ///< cd/m2
        Box3 box;
        std::vector<Vec3> places; ///< as in places()
    };
    std::vector<Area> areas_;
};

} // namespace keiko
