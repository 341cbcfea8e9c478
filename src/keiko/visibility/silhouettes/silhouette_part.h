#pragma once

#include "keiko/visibility/nets/affine_bounds.h"
#include "keiko/visibility/nets/degree_reduced_net.h"
#include "keiko/visibility/nets/gradient_bounds.h"
#include "keiko/visibility/nets/linearized_system.h"
#include "keiko/visibility/nets/net_frame.h"
#include "keiko/visibility/silhouettes/shadow_wedge.h"
#include "keiko/visibility/silhouettes/view_volume.h"

#include <optional>
#include <vector>

namespace keiko {

/// What is asked of parts in a frame: silhouettes in a plane through the viewpoint that hide some
/// of a segment. Weights of homogeneous coordinates.
struct Section {
    Vec4 plane;                ///< the distance to it
    std::array<Vec4, 2> sides; ///< how far inside of the wedge's

    /// `reach`: of the parts' points from the frame's centre, mm.
    Section(const NetFrame& frame, double reach, const SegmentPlane& of, const ShadowWedge& hidden)
        : plane(frame.local(of.weights(frame.center))), sides(hidden.weights(frame.center, reach)) {
        for (Vec4& side : sides) side = frame.local(side);
    }

    /// Whether all is proved to lie outside of the wedge.
    bool misses(const AffineBounds& points) const {
        return points.weighed(sides[0]).most() < 0 || points.weighed(sides[1]).most() < 0;
    }
};

/// A part of a patch that a viewpoint may see edge-on. It halves where a segment needs it smaller;
/// the halves are kept, so that all segments of the viewpoint share what does not depend on them.
class SilhouettePart {
public:
    /// `points`: over `uv` of the patch, in a frame; `edge_on`: over the same, zero where the
    /// viewpoint sees it edge-on; `shares`: sides of `uv` as shares of those of the box that it was
    /// lowered on.
    SilhouettePart(const Box2& uv, HomogeneousNet points, DegreeReducedScalar edge_on,
                   const Vec2& shares);

    const Box2& uv() const { return uv_; }
    const HomogeneousNet& points() const { return points_; }
    const DegreeReducedScalar& edge_on() const { return edge_on_; }

    /// Calls `solve(part, pair)` for each part that is proved, by `pair`, to hold at most one
    /// silhouette in the section, and may hold one. Where more may be, and where that returns
    /// false, it is halved, and after `most_halvings` given to `search(part)`.
    template <class Solve, class Search>
    void each_part(const Section& section, int most_halvings, const Solve& solve,
                   const Search& search) {
        if (section.misses(bounds_)) return;
        const AffineBounds::Weighed distance = bounds_.weighed(section.plane);
        if (distance.vanishes_nowhere()) return;
        const LinearizedSystem pair(distance, slopes_.all);
        if (pair.root_is_outside()) return;
        if (pair.variation() < LinearizedSystem::proved && solve(*this, pair)) return;
        if (most_halvings == 0) return search(*this);
        for (SilhouettePart& half : halves())
            half.each_part(section, most_halvings - 1, solve, search);
    }

    /// Whether a part of it, halved `most_halvings` times, may lie in `volume`, by some of its
    /// sides; `frame`: of the points.
    bool may_be_in(const ViewVolume& volume, ViewVolume::Sides sides, const NetFrame& frame,
                   int most_halvings);

private:
    std::vector<SilhouettePart>& halves();

    Box2 uv_;
    HomogeneousNet points_;
    AffineBounds bounds_;
    DegreeReducedScalar edge_on_;
    Vec2 shares_;
    GradientBounds slopes_;                               ///< with their errors
    std::optional<std::vector<SilhouettePart>> halves_{}; ///< those that may be seen edge-on
};

} // namespace keiko
