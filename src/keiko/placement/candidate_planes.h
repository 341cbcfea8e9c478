#pragma once

#include "keiko/placement/lamp_field.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/symmetry.h"

#include <vector>

namespace keiko {

/// Where planes are looked for.
struct PlaneChoice {
    std::vector<Vec3> towards;      ///< unit directions from the body; none: any
    std::vector<PlaneFrame> frames; ///< these planes and no others, unless there are none
};

/// Planes worth trying for the samples that still wait: a ceiling, walls on four sides, and
/// planes that face what is mirrored (the mean mirror direction, and the directions around which
/// many are gathered), each at several distances from the middle of what is seen, as multiples of
/// its size. u is along the vehicle's x axis as far as the plane allows. In a fixed order.
std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice = {});

/// The same for lamps that are to be symmetric about a mirror: planes that are their own images,
/// and of planes and their images, which face aside, one each.
std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice,
                                         const MirrorPlane& mirror);

} // namespace keiko
