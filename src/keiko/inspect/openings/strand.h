#pragma once

#include "keiko/inspect/openings/free_edges.h"

#include <vector>

namespace keiko {

/// The path along free edges from the end of a seam.
class Strand {
public:
    /// The path from `start` to an edge's end without a next one, to `reach` mm or to the end
    /// `back`.
    Strand(const FreeEdges& edges, FreeEnd start, FreeEnd back, double reach);

    double length() const { return length_; }
    /// True if it leads around a hole.
    bool closed() const { return closed_; }
    /// The lowest number of its free edges.
    std::uint32_t lowest_edge() const;
    /// mm: the largest deviation of its free edges.
    double deviation() const;

    FreePlace at(double way) const;
    /// The corners of its polyline up to a length, and the place there.
    std::vector<FreePlace> places(double until) const;

private:
    struct Part {
        FreeEnd from;
        double begin; ///< mm
    };
    const FreeEdges* edges_;
    std::vector<Part> parts_;
    double length_ = 0;
    bool closed_ = false;
};

/// The place of a polyline's corners or chords that is nearest to `p`. On chords it has the
/// parameter of the nearer corner.
FreePlace nearest_place(const std::vector<FreePlace>& line, const Vec3& p);

} // namespace keiko
