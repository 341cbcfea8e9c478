#pragma once

#include "keiko/intersect/hit/surface_interaction.h"
#include "keiko/visibility/nets/degree_reduced_net.h"
#include "keiko/visibility/silhouettes/chord_elevation.h"
#include "keiko/visibility/silhouettes/silhouette_part.h"
#include "keiko/visibility/silhouettes/silhouette_piece.h"

#include <memory>
#include <optional>
#include <vector>

namespace keiko {

/// Ranges of a function's second derivatives over [-1, 1]^2.
struct NetCurvature {
    NetRange xx, xy, yy; ///< by x twice, by both, by y twice

    /// True if the matrix of second derivatives is proved definite everywhere, with one sign: the
    /// function's gradient has one zero at most.
    bool definite() const;
};

/// Curvature of a function by the ranges of its second derivatives' coefficients.
NetCurvature net_curvature(const ScalarNet& net);
/// Curvature of the function `exact` that `lowered` approximates, cheaper where the approximation
/// is so close that Markov's inequality says enough of its derivatives.
NetCurvature net_curvature(const DegreeReducedScalar& lowered, const ScalarNet& exact);

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

    /// Axes of the parts' points: the last one is the normal at the viewpoint.
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

/// A piece that a viewpoint may see edge-on, with what does not depend on the segment.
struct SilhouetteCandidate {
    std::uint32_t piece = 0;         ///< into Silhouettes::pieces
    AffineBounds::Weighed edge_on{}; ///< zero where the piece is seen edge-on
    /// Once a segment needs more than `edge_on`: holds nothing where the piece is proved to be seen
    /// edge-on nowhere.
    mutable std::optional<std::unique_ptr<SilhouettePart>> part{};

    /// True if a segment has asked already and the piece was proved to be seen edge-on nowhere.
    bool nowhere_edge_on() const { return part && !*part; }
};

/// The part of a patch around a viewpoint that lies on it, where the zero at the viewpoint itself
/// makes itself felt: searched without the viewpoint.
struct OwnCandidate {
    std::uint32_t patch = 0;              ///< into Silhouettes::patches
    Box2 uv;                              ///< of that patch: the pieces around, and the viewpoint
    Vec2 foot{0};                         ///< the viewpoint
    bool trimmed = false;                 ///< the face is
    std::optional<SelfOcclusion> rings{}; ///< set by CandidateMaker::finish()
    /// Sine of the elevation over the tangent plane above which the viewpoint sees nothing of the
    /// part.
    double steepest = 1;
};

/// All that one viewpoint may see edge-on.
struct SilhouetteCandidates {
    std::vector<SilhouetteCandidate> pieces; ///< that the viewpoint does not lie on or next to
    std::vector<OwnCandidate> own;           ///< one a patch whose surface the viewpoint lies on

    /// Sine of the elevation above which no part of `own` hides anything.
    double own_steepest() const;
};

/// Finds the pieces of a model that a viewpoint may see edge-on. Keeps references to both
/// arguments.
class CandidateMaker {
public:
    /// Maker of candidates among the pieces of a model.
    CandidateMaker(const Silhouettes& silhouettes, const SubPatchKernels& kernels)
        : silhouettes_(silhouettes), kernels_(kernels) {}

    /// Adds a piece to the candidates of a viewpoint that may see it edge-on. One around the
    /// viewpoint is left out where it hides nothing so high over the horizon.
    void add(std::uint32_t piece, const Viewpoint& viewpoint,
             const std::optional<ViewpointHorizon>& horizon, SilhouetteCandidates& all) const;
    /// Once all are added: makes the own ones ready, and drops those that together hide nothing so
    /// high, and those that no plane through the viewpoint cuts a silhouette of.
    void finish(const Viewpoint& viewpoint, const std::optional<ViewpointHorizon>& horizon,
                SilhouetteCandidates& all) const;

private:
    /// Place of a viewpoint on a piece's patch, or on its continuation close by, if it lies on the
    /// surface. That is on its own patch, on a neighbour, or on another face's share of the same
    /// surface.
    std::optional<Vec2> foot(const SilhouettePiece& piece, const Viewpoint& viewpoint) const;

    const Silhouettes& silhouettes_;
    const SubPatchKernels& kernels_;
};

/// Jet of a patch's points, relative to its centre.
inline SurfaceJet jet_on(const SubPatchKernels& kernels, const OccluderPatch& patch,
                         const Vec2& uv) {
    return projected(kernels.evaluate(patch.points.view(), uv), patch.rational);
}

} // namespace keiko
