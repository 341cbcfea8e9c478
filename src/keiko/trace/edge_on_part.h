#pragma once

#include "keiko/trace/linear_pair.h"
#include "keiko/trace/lowered_net.h"
#include "keiko/trace/seen_wedge.h"
#include "keiko/trace/silhouette_piece.h"
#include "keiko/trace/slopes.h"

#include <optional>
#include <vector>

namespace keiko {

/// A patch that one apex looks at.
struct SeenPatch {
    const OccluderPatch* patch;
    std::optional<Vec3> apex; ///< relative to the patch's centre; nothing for parallel light
};

/// What is asked for: silhouettes in a plane through the apex.
struct Section {
    Vec4 weights; ///< of the plane, relative to the patch's centre
    std::optional<SeenWedge> wedge{};
};

/// A part of a patch that an apex may see edge-on. It halves where a segment needs it smaller; the
/// halves are kept, so that all segments of the apex share what does not depend on them.
class EdgeOnPart {
public:
    /// `edge_on`: over `uv` of the patch, zero where the apex sees it edge-on; `shares`: sides of
    /// `uv` as shares of those of the box that it was lowered on. `points`: over `uv`.
    EdgeOnPart(const SeenPatch& seen, const Box2& uv, HomogeneousNet points, LoweredScalar edge_on,
               const Vec2& shares);

    const Box2& uv() const { return uv_; }
    const LoweredScalar& edge_on() const { return edge_on_; }

    /// Calls `visit(part, distance, pair)` for each part that may hold a silhouette in the section:
    /// at most one, or halved `most_halvings` times. `distance`: of the part to the plane;
    /// `pair`: what its slopes and those of `edge_on` prove.
    template <class Visit>
    void each_part(const SeenPatch& seen, const Section& section, int most_halvings,
                   const Visit& visit) {
        if (section.wedge && !section.wedge->may_hold(from_apex_, reach_)) return;
        const ScalarNet distance = weighed(points_, section.weights);
        if (!may_vanish(distance)) return;
        const LinearPair pair(slopes_of(distance).all, slopes_.all);
        if (pair.root_is_outside()) return;
        if (pair.variation() < LinearPair::proved || most_halvings == 0)
            return visit(*this, distance, pair);
        for (EdgeOnPart& half : halves(seen))
            half.each_part(seen, section, most_halvings - 1, visit);
    }

private:
    std::vector<EdgeOnPart>& halves(const SeenPatch& seen);

    Box2 uv_;
    HomogeneousNet points_;
    std::vector<Vec3> from_apex_; ///< to the control points, times their weights
    double reach_ = 0;            ///< largest component of them
    LoweredScalar edge_on_;
    Vec2 shares_;
    Slopes slopes_;                                   ///< with their errors
    std::optional<std::vector<EdgeOnPart>> halves_{}; ///< those that may be seen edge-on
};

} // namespace keiko
