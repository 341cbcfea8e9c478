#pragma once

#include "keiko/light/areas/curved_lights.h"
#include "keiko/math/vec.h"

#include <optional>

namespace keiko {

/// The part of a lateral surface that faces a point: the straight generators from the first rim to
/// the second at angles around the axis from -half to half. Vectors count from the point.
struct FrustumView {
    Vec3 from{0}, to{0};              ///< mm, centers of the rims
    double radius = 0, to_radius = 0; ///< mm, of the rims
    Vec3 along{0};                    ///< unit, from the first rim to the second
    Vec3 nearest{0};                  ///< unit, across the axis to the point: angle 0
    Vec3 beside{0};                   ///< unit, across both: angle pi / 2
    double half = 0;                  ///< radians, above 0; pi if all of it faces the point

    /// nullopt if no part of the surface faces the point.
    static std::optional<FrustumView> of(const FrustumLight& light, const Vec3& point);
    /// Unit direction from the axis at an angle.
    Vec3 outwards(double angle) const;
    /// Place of the first rim at an angle.
    Vec3 on_rim(double angle) const { return from + outwards(angle) * radius; }
    /// Place of the second rim at an angle.
    Vec3 on_to_rim(double angle) const { return to + outwards(angle) * to_radius; }
    /// True if the whole way around faces the point.
    bool all_around() const;
};

} // namespace keiko
