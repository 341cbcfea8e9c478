#pragma once

#include "keiko/intersect/hit/surface_jet.h"
#include "keiko/visibility/silhouettes/self_occlusion.h"
#include "keiko/visibility/silhouettes/silhouette_piece.h"

#include <memory>
#include <optional>
#include <vector>

namespace keiko {

/// A piece that a viewpoint may see edge-on, with what does not depend on the segment.
struct SilhouetteCandidate {
    std::uint32_t piece = 0;
    AffineBounds::Weighed edge_on{}; ///< zero where the piece is seen edge-on
    /// Once a segment needs more than `edge_on`: holds nothing where the piece is proved to be seen
    /// edge-on nowhere.
    mutable std::optional<std::unique_ptr<SilhouettePart>> part{};

    bool nowhere_edge_on() const { return part && !*part; }
};

/// The part of a patch around a viewpoint that lies on it, where the zero at the viewpoint itself
/// makes itself felt: searched without the viewpoint.
struct OwnCandidate {
    std::uint32_t patch = 0; ///< into Silhouettes::patches
    Box2 uv;                 ///< of that patch: the pieces around, and the viewpoint
    Vec2 foot{0};            ///< the viewpoint
    bool trimmed = false;    ///< the face is
    std::optional<SelfOcclusion> rings{};
    /// Sine of the elevation over the tangent plane above which the viewpoint sees nothing of the
    /// part.
    double steepest = 1;
};

/// All that one viewpoint may see edge-on.
struct SilhouetteCandidates {
    std::vector<SilhouetteCandidate> pieces;
    std::vector<OwnCandidate> own;

    /// Sine of the elevation above which no part of `own` hides anything.
    double own_steepest() const;
};

/// Tells what of a model a viewpoint may see edge-on, piece by piece. Looks into both.
class CandidateMaker {
public:
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
    /// Where a viewpoint on the surface lies on a piece's patch, or on its continuation close by:
    /// on its own patch, on a neighbour, or on another face's share of the same surface.
    std::optional<Vec2> foot(const SilhouettePiece& piece, const Viewpoint& viewpoint) const;

    const Silhouettes& silhouettes_;
    const SubPatchKernels& kernels_;
};

/// Of a patch's points, relative to its centre.
inline SurfaceJet jet_on(const SubPatchKernels& kernels, const OccluderPatch& patch,
                         const Vec2& uv) {
    return projected(kernels.evaluate(patch.points.view(), uv), patch.rational);
}

} // namespace keiko
