#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/bounds.h"
#include "keiko/placement/lamp_field.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/symmetry.h"

#include <array>
#include <vector>

namespace keiko {

/// A box along three unit axes of its own; may be flat.
struct OrientedBox {
    Vec3 center{0};
    std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    Vec3 half{0}; ///< half the edge lengths
};

OrientedBox oriented(const Box3& box);
/// The room that the lamps of a C-plane take.
OrientedBox oriented(const CPlane& plane);

/// Whether two boxes have a point in common (separating axes [Gottschalk1996]).
bool overlap(const OrientedBox& a, const OrientedBox& b);

/// Restriction of the planes that are searched.
struct PlaneChoice {
    std::vector<Vec3> towards;      ///< unit directions from the body; none: any
    std::vector<PlaneFrame> frames; ///< these planes and no others, unless there are none
};

/// Planes worth trying for the samples that still wait: a ceiling, walls on four sides, and
/// planes that face what is mirrored (the mean mirror direction, and the directions around which
/// many are gathered), each at several distances from the middle of what is seen, as multiples of
/// its size. u is along the vehicle's x axis as far as the plane allows. In a fixed order.
std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice = {});

/// Planes worth trying for lamps that are to be symmetric about a mirror: planes that are their own
/// images, and of planes and their images, which face aside, one each.
std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice,
                                         const MirrorPlane& mirror);

} // namespace keiko
