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

/// Places that stand for a lamp of a source as a point sees it; none where it has no light. A tube
/// has 8 on its axis, a panel 4 x 4 in its rectangle, a sphere 2 x 2 x 2 in its box. A panel of the
/// sky has 16 in each triangle, by their solid angles. A light without extent has one.
std::vector<LampPlace> lamp_places(const PreparedSource& source, int lamp, const Vec3& point);

} // namespace keiko
