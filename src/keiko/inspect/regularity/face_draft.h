#pragma once

#include "keiko/base/units.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/scene/draft_limit.h"

#include <optional>

namespace keiko {

/// Draft angle in degrees, -90 to 90: 90 less the angle between an outward normal and the pull. It
/// is 0 on walls along the pull and negative on undercuts.
inline double draft_angle(const Vec3& normal, const Vec3& pull) {
    return 90 - radians_to_degrees(angle_between(normal, pull));
}

/// Degrees by which a draft angle may miss its limit and pass. Walls are often drawn at the limit
/// itself.
constexpr double draft_tolerance = 1e-3;

/// The smallest draft angle of a placed face within its trims, in degrees, and its place, judged by
/// the limit. The normal is the outward one that the file gives the face. It is found by branch and
/// bound of the normals in Bernstein form (docs/theory/inspection.md): the true one is smaller by
/// `bound` at most, half of draft_tolerance unless `most_splits` cuts of pieces do not suffice.
/// Places where the normal is undefined are left out, with surroundings of a thousandth of the
/// face. nullopt for a face that its trims leave no material of.
std::optional<MeasuredValue> smallest_draft(const SurfaceModel& model, std::uint32_t instance,
                                            std::uint32_t face, const DraftLimit& limit,
                                            std::size_t most_splits = 5000);

} // namespace keiko
