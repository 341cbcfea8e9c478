#pragma once

#include "keiko/base/export.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/bounds.h"
#include "keiko/placement/lamp_field.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/symmetry.h"

#include <array>
#include <vector>

namespace KEIKO_API keiko {

/// A box along three unit axes of its own; may be flat.
struct OrientedBox {
    Vec3 center{0}; ///< mm
    /// Unit, at right angles.
    std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    Vec3 half{0}; ///< half the edge lengths
};

/// The box as one along its own axes.
OrientedBox oriented(const Box3& box);
/// The volume of the lamps of a C-plane.
OrientedBox oriented(const CPlane& plane);

/// True if two boxes have a point in common (separating axes [Gottschalk1996]).
bool overlap(const OrientedBox& a, const OrientedBox& b);

/// Restriction of the planes that are searched.
struct PlaneChoice {
    std::vector<Vec3> towards;      ///< unit directions from the body; none: any
    std::vector<PlaneFrame> frames; ///< only these planes, unless empty
};

/// Candidate planes for the samples that are still uncovered, in a fixed order. They are a ceiling,
/// walls on four sides, and planes that face the reflections: the mean mirror direction, and the
/// directions around which many are gathered. Each is at several distances from the middle of the
/// visible part, as multiples of its size. u is along the vehicle's x axis as far as the plane
/// allows.
std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice = {});

/// Candidate planes for lamps that are symmetric about a mirror: planes that are their own images,
/// and one each of planes that face aside and their images.
std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice,
                                         const MirrorPlane& mirror);

} // namespace keiko
