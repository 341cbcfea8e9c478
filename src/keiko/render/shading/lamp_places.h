#pragma once

#include "keiko/light/rig/prepared_rig.h"
#include "keiko/math/vec.h"

#include <vector>

namespace keiko {

/// A place that light of a lamp comes from.
struct LampPlace {
    Vec3 place{0};     ///< mm
    double weight = 1; ///< its part of the lamp's light, in any unit
};

/// Places that stand for a lamp of a source as a point sees it: 8 on a tube's axis, 4 x 4 in the
/// rectangle of a panel, 2 x 2 x 2 in the box of a sphere, 16 in each triangle of a panel of the
/// sky, by their solid angles, and one of a light without extent. Empty where there is no light.
std::vector<LampPlace> lamp_places(const PreparedSource& source, int lamp, const Vec3& point);

} // namespace keiko
