#pragma once

#include "keiko/inspect/openings/free_edges.h"

#include <optional>
#include <vector>

namespace keiko {

/// The path along free edges from the end of a seam.
class Strand {
public:
    /// The path from `start` to an edge's end without a next one or to the end `back`. It stops
    /// behind the first edge at whose far end it is `reach` mm long or longer.
    Strand(const FreeEdges& edges, FreeEnd start, FreeEnd back, double reach);

    /// mm, of all its free edges; the gaps between their ends do not count.
    double length() const { return length_; }
    /// True if it leads around a hole.
    bool closed() const { return closed_; }
    /// The lowest number of its free edges.
    std::uint32_t lowest_edge() const;
    /// mm: the largest deviation of its free edges.
    double deviation() const;

    /// The place `way` mm along the path; its first or last place beyond its ends.
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

/// The size of a hole, and the side of its outline on which the faces lie.
struct HoleForm {
    double width = 0;  ///< mm: the least breadth of the outline viewed along its normal
    double length = 0; ///< mm: the breadth at right angles to that
    double depth = 0;  ///< mm: the extent of the outline along its normal
    double area = 0;   ///< mm2, enclosed, viewed along its normal
    Vec3 middle{0};    ///< world, mm: the centroid of the outline
    /// Mean cosines, over the outline, of the angle between the outward direction from the middle
    /// and the direction into the face there: the part of positive cosines and, as a positive
    /// number, of negative ones.
    double away = 0, nearer = 0;

    /// True if it is a hole in the faces. At the rim of a tube both means are small. At the border
    /// of a small part only the second is large. At a hole on one side of a sharp crease both are
    /// nearly equal.
    bool is_within_faces() const;
};

/// The form of a closed outline; nullopt if it encloses no area.
std::optional<HoleForm> hole_form(const BoundaryCurves& curves, const FreeEdges& edges,
                                  const Strand& outline);

} // namespace keiko
