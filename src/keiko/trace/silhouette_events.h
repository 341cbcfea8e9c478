#pragma once

#include "keiko/trace/own_rings.h"
#include "keiko/trace/segment_plane.h"
#include "keiko/trace/silhouette_piece.h"
#include "keiko/trace/silhouette_search.h"
#include "keiko/trace/surface_jet.h"

#include <memory>
#include <vector>

namespace keiko {

/// A piece that an apex may see edge-on, with what does not depend on the segment.
struct SilhouetteCandidate {
    std::uint32_t piece = 0;
    AffineBounds::Weighed edge_on{}; ///< zero where the piece is seen edge-on
    /// Once a segment needs more than `edge_on`: holds nothing where the piece is proved to be seen
    /// edge-on nowhere.
    mutable std::optional<std::unique_ptr<EdgeOnPart>> part{};

    bool nowhere_edge_on() const { return part && !*part; }
};

/// The part of a patch around an apex that lies on it, where the zero at the apex itself makes
/// itself felt: searched without the apex.
struct OwnCandidate {
    std::uint32_t patch = 0; ///< into Silhouettes::patches
    Box2 uv;                 ///< of that patch: the pieces around, and the apex
    Vec2 foot{0};            ///< the apex
    bool trimmed = false;    ///< the face is
    std::optional<OwnRings> rings{};
    /// Sine of the elevation over the tangent plane above which the apex sees nothing of the part.
    double steepest = 1;
};

/// All that one apex may see edge-on.
struct SilhouetteCandidates {
    std::vector<SilhouetteCandidate> pieces;
    std::vector<OwnCandidate> own;

    /// Sine of the elevation above which no part of `own` hides anything.
    double own_steepest() const;
};

/// Finds where silhouettes, seen from one apex, hide a segment first or last: common zeros of
/// m.(S - P) and (S_u x S_v).(S - P) (physics 4.3). Where the two functions are proved to have at
/// most one on a piece, Newton's method finds it; elsewhere the piece is split until they are, or
/// until what is left is a single event to within rounding.
class SilhouetteSolver {
public:
    SilhouetteSolver(const Silhouettes& silhouettes, const LeafKernels& kernels)
        : silhouettes_(silhouettes), kernels_(kernels) {}

    /// Adds a piece to the candidates of an apex that may see it edge-on. One around the apex is
    /// left out where it hides nothing so high over the horizon.
    void add_candidate(std::uint32_t piece, const Apex& apex,
                       const std::optional<ApexHorizon>& horizon, SilhouetteCandidates& all) const;
    /// Once all are added: makes the own ones ready, and drops those that together hide nothing so
    /// high, and those that no plane through the apex cuts a silhouette of.
    void finish(const Apex& apex, const std::optional<ApexHorizon>& horizon,
                SilhouetteCandidates& all) const;
    /// Appends the events of a candidate at which it hides some of the segment in `wedge`; false
    /// when some could not be told apart.
    bool find(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
              const SeenWedge& wedge, std::vector<VisibilityEvent>& events) const;
    bool find(const OwnCandidate& own, const SegmentPlane& plane, const SeenWedge& wedge,
              std::vector<VisibilityEvent>& events) const;
    /// False when all that `apex` sees edge-on of a candidate is proved to lie outside.
    bool may_be_in(const ViewVolume& volume, const SilhouetteCandidate& candidate,
                   const Apex& apex) const;

private:
    /// Where an apex on the surface lies on a piece's patch, or on its continuation close by: on
    /// its own patch, on a neighbour, or on another face's share of the same surface.
    std::optional<Vec2> foot(const SilhouettePiece& piece, const Apex& apex) const;
    /// The root that Newton's method finds from a place of the patch's [0, 1]^2 in steps measured
    /// against `extent`.
    std::optional<Vec2> newton(const OccluderPatch& patch, Vec2 uv, const Vec2& extent,
                               const SegmentPlane& plane) const;
    /// Where `pair` proves that there is at most one event over a box of a patch: finds it. False
    /// where nothing is proved.
    bool add_only_root(const LinearPair& pair, std::uint32_t patch, const Box2& uv, bool trimmed,
                       const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const;
    /// A part of a patch that is searched.
    struct Part {
        std::uint32_t patch;
        Box2 uv;
        bool trimmed;
        double size; ///< mm
    };
    void find_part(const SilhouetteCandidate& candidate, const Apex& apex) const;
    /// Appends the events in a part on which nothing is proved yet; false when some could not be
    /// told apart.
    bool search(const EdgeOnPart& in, const Section& section, const Part& part,
                const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const;
    SilhouetteSearch::Result run(const SilhouetteSearch& search, const Part& part,
                                 const SegmentPlane& plane, int most_boxes) const;
    bool add(const SilhouetteSearch::Result& found, const Part& part, const SegmentPlane& plane,
             std::vector<VisibilityEvent>& events) const;
    SurfaceJet jet_at(const OccluderPatch& patch, const Vec2& uv) const;
    void add(const OccluderPatch& patch, bool trimmed, const Vec2& uv, const SegmentPlane& plane,
             std::vector<VisibilityEvent>& events) const;

    const Silhouettes& silhouettes_;
    const LeafKernels& kernels_;
};

} // namespace keiko
