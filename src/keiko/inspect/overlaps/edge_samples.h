#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/inspect/openings/free_edges.h"

#include <vector>

namespace keiko {

/// Numbered samples of free edges: the corners of their polylines, and uniformly spaced places
/// between them. Numbers rise by 1 along each edge.
class FreeEdgeSamples {
public:
    /// A chord of an edge's polyline with `steps` + 1 samples; its last one is the first of the
    /// next chord. Numbers are those of its samples.
    struct Chord {
        std::uint32_t edge = 0, place = 0; ///< into FreeEdges::all and FreeEdge::places
        std::uint32_t first = 0;           ///< number of its first sample, at `from`
        std::uint32_t steps = 1;           ///< equal parts into which samples divide it
        Vec3 from{0}, to{0};               ///< world, mm

        /// The sample `step` steps from `from`, 0 to `steps`; world, mm.
        Vec3 at(std::uint32_t step) const { return from + (to - from) * (double(step) / steps); }
    };

    /// Samples at most `step` mm apart along each edge. Keeps a reference to `edges`.
    FreeEdgeSamples(const FreeEdges& edges, double step);

    /// The edges that are sampled.
    const FreeEdges& edges() const { return edges_; }
    /// A chord by its index: edge after edge, in the order along each.
    const Chord& chord(std::uint32_t index) const { return chords_[index]; }
    /// The chords that may meet a box, ascending.
    std::vector<std::uint32_t> chords_in(const Box3& box) const { return tree_.overlapping(box); }
    /// The edge of a sample.
    std::uint32_t edge_of(std::uint32_t sample) const { return chord_of(sample).edge; }
    /// mm along its edge.
    double way(std::uint32_t sample) const;
    /// The place of a sample, with the number of its edge.
    FreePlace place(std::uint32_t sample) const;

private:
    const Chord& chord_of(std::uint32_t sample) const;
    std::vector<Box3> list_chords(double step);

    const FreeEdges& edges_;
    std::vector<Chord> chords_;
    BoxTree tree_;
};

} // namespace keiko
