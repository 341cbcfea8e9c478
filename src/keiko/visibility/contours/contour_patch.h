#pragma once

#include "keiko/geometry/rays/contour_arc.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/visibility/nets/affine_bounds.h"
#include "keiko/visibility/silhouettes/silhouette_piece.h"

#include <vector>

namespace keiko {

/// Value of a net at a place, by its Bernstein polynomials.
Vec4 value_of(const HomogeneousNet& net, const Vec2& uv);

/// A curved patch of a luminous body, whose silhouettes from any point are traced as arcs of conic
/// sections. Keeps references to both arguments.
class ContourPatch {
public:
    /// `side`: 1 if the normal du x dv is the outer one, else -1. `region`: of the face if trim
    /// curves may cross the patch, else null.
    ContourPatch(const OccluderPatch& patch, double side, const TrimRegion* region)
        : patch_(&patch), side_(side), region_(region), bounds_(affine_bounds(patch.planes)) {}

    const OccluderPatch& patch() const { return *patch_; }
    /// Tangent plane at a place of the model's patch, as weights of homogeneous coordinates
    /// relative to `center`; above 0 on its outer side.
    Vec4 outer_plane(const Vec2& uv, const Vec3& center) const;
    /// Silhouettes from a point. Arcs are halved, ten times at most, until they are within
    /// `allowed` rad of the exact line of sight at two places between their ends and their middles.
    /// Trim curves cut them as 25 samples of each tell.
    void append_arcs(const Vec3& point, double allowed, ContourArcs& arcs) const;

private:
    const OccluderPatch* patch_;
    double side_;
    const TrimRegion* region_;
    AffineBounds bounds_;
};

} // namespace keiko
