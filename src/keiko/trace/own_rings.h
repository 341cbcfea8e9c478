#pragma once

#include "keiko/trace/linear_pair.h"
#include "keiko/trace/lowered_net.h"
#include "keiko/trace/seen_wedge.h"
#include "keiko/trace/silhouette_piece.h"
#include "keiko/trace/slopes.h"

#include <optional>
#include <vector>

namespace keiko {

/// The surroundings of an apex that lies on a patch, for silhouettes near it. The apex itself is a
/// zero of second order of the function that tells where it sees its surface edge-on. It is kept
/// out: in boxes about it, each a fifth of the one before, and the rings between them. What does
/// not depend on the segment is made once, when the first segment asks for it. Looks into the
/// patch.
class OwnRings {
public:
    /// `uv`: the surroundings, of the patch; `foot`: the apex there; `normal`: unit, of the
    /// surface there, if known. `edge_on`: over `uv`, zero where the apex sees the surface edge-on.
    OwnRings(const OccluderPatch& patch, const Box2& uv, const Vec2& foot,
             const std::optional<Vec3>& normal, ScalarNet edge_on);

    /// A part of a ring, which halves where segments need it smaller.
    struct Part {
        Box2 uv; ///< of the patch
        HomogeneousNet points;
        std::vector<Vec3> seen; ///< control points from the apex, times their weights
        double reach;           ///< of the farthest of `seen`
        ScalarNet edge_on; ///< lowered
        double error;      ///< of `edge_on`
        Vec2 shares;       ///< sides as shares of those of the box it was lowered on
        Slopes slopes;     ///< with their errors
        /// Sine of the elevation over the tangent plane above which it hides nothing.
        double steepest = 1;
        int halvings = 0;
        std::optional<std::vector<Part>> halves{}; ///< those that the apex may see edge-on
    };
    /// What is asked for: silhouettes in a plane through the apex.
    struct Section {
        Vec4 weights;     ///< of the plane, relative to the patch's centre
        double elevation; ///< sine of the least one over the tangent plane
        SeenWedge wedge;
    };
    /// Calls `visit(part, distance, pair)` for each part that may hold such silhouettes, at most
    /// one or as small as parts get. `distance`: of the part to the plane; `pair`: what its slopes
    /// and those of `edge_on` prove.
    template <class Visit>
    void each_part(const Section& section, const Visit& visit) const {
        for (std::size_t k = 0; k < most_boxes && !only_apex_in(k, section.weights); ++k)
            for (Part& part : ring(k)) descend(part, section, visit);
    }

    /// What `edge_on` of a part is an approximation of.
    ScalarNet exact(const Part& part) const {
        return restricted(edge_on_, {(part.uv.lower - uv_.lower) / uv_.extent(),
                                     (part.uv.upper - uv_.lower) / uv_.extent()});
    }

private:
    static constexpr std::size_t most_boxes = 11; ///< 5^-10: what is left is the apex itself
    static constexpr int most_halvings = 8;

    struct Shell {
        Box2 box; ///< of the surroundings
        HomogeneousNet points;
        LoweredScalar edge_on;
        /// Second derivatives of `edge_on`.
        NetRange xx, xy, yy;
        std::optional<std::vector<Part>> ring{}; ///< between this box and the next
    };
    Box2 of_patch(const Box2& box) const {
        return {uv_.lower + uv_.extent() * box.lower, uv_.lower + uv_.extent() * box.upper};
    }
    template <class Visit>
    void descend(Part& part, const Section& section, const Visit& visit) const {
        if (part.steepest < section.elevation) return;
        if (!section.wedge.may_hold(part.seen, part.reach)) return;
        const ScalarNet distance = weighed(part.points, section.weights);
        if (!may_vanish(distance)) return;
        const LinearPair pair(slopes_of(distance).all, part.slopes.all);
        if (pair.root_is_outside()) return;
        if (pair.variation() < LinearPair::proved || part.halvings == most_halvings)
            return visit(part, distance, pair);
        for (Part& half : halves(part)) descend(half, section, visit);
    }
    /// Whether the plane finds no silhouette in a box but at the apex.
    bool only_apex_in(std::size_t k, const Vec4& weights) const;
    std::vector<Part>& ring(std::size_t k) const;
    std::vector<Part>& halves(Part& part) const;
    void add_part(const Box2& uv, LoweredScalar edge_on, const Vec2& shares, int halvings,
                  std::vector<Part>& parts) const;
    Shell& shell(std::size_t k) const;
    std::vector<Vec3> seen_by_apex(const HomogeneousNet& points) const;
    double steepest(const HomogeneousNet& points) const;

    const OccluderPatch* patch_;
    Box2 uv_;
    Vec2 foot_; ///< of the surroundings
    Vec3 apex_; ///< relative to the patch's centre
    std::optional<Vec3> normal_;
    ScalarNet edge_on_;
    mutable std::vector<Shell> shells_;
};

} // namespace keiko
