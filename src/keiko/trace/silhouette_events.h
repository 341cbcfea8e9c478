#pragma once

#include "keiko/trace/leaf_kernels.h"
#include "keiko/trace/segment_plane.h"
#include "keiko/trace/silhouette_piece.h"
#include "keiko/trace/surface_jet.h"

#include <vector>

namespace keiko {

/// A piece that an apex may see edge-on, with what does not depend on the segment.
struct SilhouetteCandidate {
    std::uint32_t piece = 0;
    AffineNet::Weighed edge_on{}; ///< zero where the piece is seen edge-on
    bool own = false;             ///< the apex lies on it
    Vec2 foot{0};                 ///< then: where, in the piece's [-1, 1]^2
};

/// Finds where silhouettes, seen from one apex, hide a segment first or last: common zeros of
/// m.(S - P) and (S_u x S_v).(S - P) (physics 4.3). Where the two functions are proved to have at
/// most one on a piece, Newton's method finds it; elsewhere the piece is split until they are, or
/// until what is left is a single event to within rounding.
class SilhouetteSolver {
public:
    SilhouetteSolver(const Silhouettes& silhouettes, const LeafKernels& kernels)
        : silhouettes_(silhouettes), kernels_(kernels) {}

    /// What there is to solve for an apex on a piece that it may see edge-on; nothing otherwise.
    std::optional<SilhouetteCandidate> candidate(std::uint32_t piece, const Apex& apex) const;
    /// Appends the events; false when some could not be told apart.
    bool find(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
              std::vector<VisibilityEvent>& events) const;

private:
    /// The root that Newton's method finds from a place of the piece's [-1, 1]^2, on it or not.
    std::optional<Vec2> newton(const SilhouettePiece& piece, Vec2 xy,
                               const SegmentPlane& plane) const;
    bool subdivide(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
                   std::vector<VisibilityEvent>& events) const;
    SurfaceJet jet_at(const OccluderPatch& patch, const Vec2& uv) const;
    void add(const SilhouettePiece& piece, const Vec2& uv, const SegmentPlane& plane,
             std::vector<VisibilityEvent>& events) const;

    const Silhouettes& silhouettes_;
    const LeafKernels& kernels_;
};

} // namespace keiko
