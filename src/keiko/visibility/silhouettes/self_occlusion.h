#pragma once

#include "keiko/visibility/nets/net_curvature.h"
#include "keiko/visibility/silhouettes/chord_elevation.h"
#include "keiko/visibility/silhouettes/silhouette_part.h"

namespace keiko {

/// The surroundings of a viewpoint that lies on a patch, for silhouettes near it. The viewpoint
/// itself is a zero of second order of the function that tells where it sees its surface edge-on.
/// It is kept out: in boxes about it, each a fifth of the one before, and the rings between them.
/// What does not depend on the segment is made once, when the first segment asks for it. Looks into
/// the patch.
class SelfOcclusion {
public:
    /// `uv`: the surroundings, of the patch; `foot`: the viewpoint there; `edge_on`: over `uv`,
    /// zero where the viewpoint sees the surface edge-on.
    SelfOcclusion(const OccluderPatch& patch, const Box2& uv, const Vec2& foot, ScalarNet edge_on);

    /// Of the parts' points: the last axis is the normal at the viewpoint.
    const NetFrame& frame() const { return frame_; }

    /// Whether no plane through the viewpoint finds a silhouette, as the second derivative is
    /// definite.
    bool find_nothing() const { return shell(0).second.definite(); }
    /// Calls `solve(part, pair)` or `search(part)` for each part that may hold silhouettes, as
    /// SilhouettePart::each_part; the section is in frame().
    template <class Solve, class Search>
    void each_part(const Section& section, const Solve& solve, const Search& search) const {
        constexpr int most_halvings = 8;
        for (std::size_t k = 0; k < most_boxes && !only_viewpoint_in(k, section.plane); ++k)
            for (SilhouettePart& part : ring(k))
                part.each_part(section, most_halvings, solve, search);
    }

    /// False when no silhouette but at the viewpoint itself may lie in `volume`, whose least
    /// elevation over the tangent plane at the viewpoint is that of `horizon`.
    bool may_be_in(const ViewVolume& volume, const Viewpoint& viewpoint,
                   const ViewpointHorizon& horizon) const;

private:
    static constexpr std::size_t most_boxes = 11; ///< 5^-10: what is left is the viewpoint itself

    struct Shell {
        Box2 box;              ///< of the surroundings
        HomogeneousNet points; ///< in frame()
        DegreeReducedScalar edge_on;
        NetCurvature second;                               ///< of what `edge_on` approximates
        std::optional<std::vector<SilhouettePart>> ring{}; ///< between this box and the next
    };
    Box2 of_patch(const Box2& box) const {
        return {uv_.lower + uv_.extent() * box.lower, uv_.lower + uv_.extent() * box.upper};
    }
    /// Whether the plane of these weights finds no silhouette in a box but at the viewpoint.
    bool only_viewpoint_in(std::size_t k, const Vec4& weights) const;
    std::vector<SilhouettePart>& ring(std::size_t k) const;
    Shell& shell(std::size_t k) const;

    const OccluderPatch* patch_;
    Box2 uv_;
    Vec2 foot_; ///< of the surroundings
    NetFrame frame_;
    HomogeneousNet points_; ///< of the patch, in the frame
    ScalarNet edge_on_;
    mutable std::vector<Shell> shells_;
};

} // namespace keiko
