#pragma once

#include "keiko/trace/linear_pair.h"
#include "keiko/trace/lowered_net.h"
#include "keiko/trace/seen_wedge.h"
#include "keiko/trace/silhouette_piece.h"
#include "keiko/trace/slopes.h"
#include "keiko/trace/view_volume.h"

#include <optional>
#include <vector>

namespace keiko {

/// What is asked of a patch: silhouettes in a plane through the apex that hide some of a segment.
struct Section {
    const OccluderPatch* patch;
    Vec4 weights; ///< of the plane, relative to the patch's centre
    const SeenWedge* wedge;

    Section(const OccluderPatch& of, const SegmentPlane& plane, const SeenWedge& hidden)
        : patch(&of), weights(plane.weights(of.center)), wedge(&hidden) {}
};

/// A part of a patch that an apex may see edge-on. It halves where a segment needs it smaller; the
/// halves are kept, so that all segments of the apex share what does not depend on them.
class EdgeOnPart {
public:
    /// `edge_on`: over `uv` of the patch, zero where the apex sees it edge-on; `shares`: sides of
    /// `uv` as shares of those of the box that it was lowered on. `points`: over `uv`.
    EdgeOnPart(const Box2& uv, HomogeneousNet points, LoweredScalar edge_on, const Vec2& shares);

    const Box2& uv() const { return uv_; }
    const LoweredScalar& edge_on() const { return edge_on_; }

    /// Calls `visit(part, distance, pair)` for each part that may hold a silhouette in the section:
    /// at most one, or halved `most_halvings` times. `distance`: of the part to the plane;
    /// `pair`: what its slopes and those of `edge_on` prove.
    template <class Visit>
    void each_part(const Section& section, int most_halvings, const Visit& visit) {
        const OccluderPatch& patch = *section.patch;
        if (!section.wedge->may_hold(points_, patch.center, patch.size)) return;
        const ScalarNet distance = weighed(points_, section.weights);
        if (!may_vanish(distance)) return;
        const LinearPair pair(slopes_of(distance).all, slopes_.all);
        if (pair.root_is_outside()) return;
        if (pair.variation() < LinearPair::proved || most_halvings == 0)
            return visit(*this, distance, pair);
        for (EdgeOnPart& half : halves()) half.each_part(section, most_halvings - 1, visit);
    }

    /// Whether a part of it, halved `most_halvings` times, may lie in `volume`; `center`: of the
    /// patch.
    bool may_be_in(const ViewVolume& volume, const Vec3& center, int most_halvings);

private:
    std::vector<EdgeOnPart>& halves();

    Box2 uv_;
    HomogeneousNet points_;
    LoweredScalar edge_on_;
    Vec2 shares_;
    Slopes slopes_;                                   ///< with their errors
    std::optional<std::vector<EdgeOnPart>> halves_{}; ///< those that may be seen edge-on
};

} // namespace keiko
