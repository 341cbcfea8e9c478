#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <vector>

namespace keiko {

/// A hit and what tells whether a neighbouring sub-patch or face may have found it too.
struct BoundaryHit {
    Hit hit;                            ///< evaluated at the crossing
    std::uint32_t sub_patch = no_index; ///< index among the placed sub-patches
    Vec2 uv{0};                         ///< of that sub-patch
    double sine = 0;     ///< of the angle to the surface; above 0 where the ray leaves the face
    bool at_end = false; ///< of its sub-patch or its patch, where the next one may have found it
    bool beyond = false; ///< its place is off its sub-patch, if by no more than the error
    bool own = true; ///< beyond doubt on that share of the face that no other sub-patch answers for
};

/// Hit of a crossing with what merged() asks of it. `hit` is the evaluated crossing; `direction` is
/// the ray's, world, of any length above 0. A place is at an end if it is no farther than its error
/// and two slips from an end of the sub-patch's share, or outside of the share. A clipped crossing
/// is never on its own share.
BoundaryHit boundary_hit(const TracedModel& model, const Crossing& crossing, Hit hit,
                         const Vec3& direction);

/// Sorted hits of one ray without the doubles that overlapping borders make. Two hits of an
/// instance are one in two cases.
///
/// Copies: neighbouring sub-patches overlap by rounding, so that both may find what lies between
/// them. The hits are crossed in the same sense. Each is at an end of its sub-patch or patch, or
/// on a sub-patch that trim curves cross. They are no farther apart, measured across the surface,
/// than their position bounds, or one is at an end and they are no farther apart at all. They are
/// not both proved to be on their own shares of one face, for then they are two.
///
/// One crossing of a seam: faces need to meet only within its width, so a ray may cross both near
/// it, or one beyond its border. Both are crossed in the same sense (in or out), with no hit of
/// the other sense between them. They are no farther apart across the surface than two widths
/// (three gaps: both borders and both hits may deviate by one each, twice in one direction). One
/// is beyond its own border or near an edge of the other's face, or each is near an edge.
///
/// The two sides of a thin sheet are crossed in opposite senses and so stay two, however thin.
/// Faces that the file turns against each other at a seam look the same: there a seam may be
/// counted twice.
/// The hit that is not a seam hit is kept, else the one on its own share, else one whose surface
/// the ray meets at more than twice the angle, else the first. Unless the other is a seam hit, its
/// bound is widened to cover both, and it is tangential if either is.
std::vector<Hit> merged(std::vector<BoundaryHit> hits, const TracedModel& model,
                        const Vec3& direction);

} // namespace keiko
