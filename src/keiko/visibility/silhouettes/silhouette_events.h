#pragma once

#include "keiko/visibility/boundaries/plane_cuts.h"
#include "keiko/visibility/silhouettes/silhouette_candidates.h"
#include "keiko/visibility/silhouettes/silhouette_part.h"

#include <vector>

namespace keiko {

/// Solver for the places where silhouettes, viewed from one viewpoint, hide a segment first or
/// last. They are common zeros of m.(S - P) and (S_u x S_v).(S - P)
/// (docs/theory/visibility.md#events). Where the two functions are proved to have at most one on a
/// piece, Newton's method finds it. Elsewhere the piece is split until they are, or until a single
/// event is left to within rounding.
class SilhouetteSolver {
public:
    /// Solver for the pieces of a model. Keeps references to both.
    SilhouetteSolver(const Silhouettes& silhouettes, const SubPatchKernels& kernels)
        : silhouettes_(silhouettes), kernels_(kernels) {}

    /// Appends the events of a candidate at which it hides some of the segment in `wedge`; false
    /// when some could not be separated.
    bool find(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
              const ShadowWedge& wedge, std::vector<VisibilityEvent>& events) const;
    /// Appends the events of the viewpoint's own surroundings likewise.
    bool find(const OwnCandidate& own, const SegmentPlane& plane, const ShadowWedge& wedge,
              std::vector<VisibilityEvent>& events) const;
    /// False when all that `viewpoint` sees edge-on of a candidate is proved to lie outside.
    bool may_be_in(const ViewVolume& volume, const SilhouetteCandidate& candidate,
                   const Viewpoint& viewpoint) const;

private:
    /// The root that Newton's method finds from a place of the patch's [0, 1]^2 in steps measured
    /// against `extent`.
    std::optional<Vec2> newton(const OccluderPatch& patch, Vec2 uv, const Vec2& extent,
                               const SegmentPlane& plane) const;
    /// Finds the only event where `pair` proves that there is at most one over a box of a patch.
    /// False where nothing is proved.
    bool add_only_root(const LinearizedSystem& pair, std::uint32_t patch, const Box2& uv,
                       bool trimmed, const SegmentPlane& plane,
                       std::vector<VisibilityEvent>& events) const;
    /// A part of a patch that is searched.
    struct Part {
        std::uint32_t patch;
        Box2 uv;
        bool trimmed;
        double size; ///< mm
    };
    void find_part(const SilhouetteCandidate& candidate, const Viewpoint& viewpoint) const;
    /// Appends the events in a part on which nothing is proved yet; false when some could not be
    /// separated.
    bool search(const SilhouettePart& in, const Section& section, const Part& part,
                const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const;
    SilhouetteSearch::Result run(const SilhouetteSearch& search, const Part& part,
                                 const SegmentPlane& plane, int most_boxes) const;
    bool add(const SilhouetteSearch::Result& found, const Part& part, const SegmentPlane& plane,
             std::vector<VisibilityEvent>& events) const;
    SurfaceJet jet_at(const OccluderPatch& patch, const Vec2& uv) const;
    void add(const OccluderPatch& patch, bool trimmed, const Vec2& uv, const SegmentPlane& plane,
             std::vector<VisibilityEvent>& events) const;

    const Silhouettes& silhouettes_;
    const SubPatchKernels& kernels_;
};

} // namespace keiko
