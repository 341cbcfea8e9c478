#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/basics/placed_face.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A place of a free edge.
struct FreePlace {
    std::uint32_t edge = 0;  ///< into FreeEdges::all
    std::uint32_t piece = 0; ///< into FreeEdge::pieces
    double t = 0;            ///< parameter of the piece's curve
    Vec3 position{0};        ///< world, mm
};

/// Consecutive free borders of one face, which meet no other border, as one polyline.
struct FreeEdge {
    std::vector<BoundaryInterval> pieces; ///< at least one, in the order of the face's loop
    std::vector<FreePlace> places;        ///< at least two, in the order of the face's loop
    std::vector<double> ways;             ///< mm along the edge to each place, rising from 0
    double deviation = 0;                 ///< mm, distance of the polyline from the borders
    bool closed = false;                  ///< a whole loop: it ends at its beginning

    /// The face whose border it is.
    PlacedFace face() const { return {pieces.front().instance, pieces.front().face}; }
    /// mm, of the polyline.
    double length() const { return ways.back(); }
    /// The place at a length along it, on a chord between two places.
    FreePlace at(double way) const;
};

/// One of the two ends of a free edge.
struct FreeEnd {
    std::uint32_t edge = 0; ///< into FreeEdges::all
    bool last = false;      ///< else the first

    /// Its index in FreeEdges::next.
    std::uint32_t number() const { return 2 * edge + last; }
    /// The end with this index in FreeEdges::next.
    static FreeEnd of_number(std::uint32_t number) { return {number / 2, number % 2 == 1}; }
    bool operator==(const FreeEnd&) const = default;
};

/// The free edges of a model and their connections where seams end, from the border of one face to
/// that of the next.
struct FreeEdges {
    /// The edges, face by face and loop by loop.
    std::vector<FreeEdge> all;
    /// The end that follows each end, by FreeEnd::number; nullopt if no end is near.
    std::vector<std::optional<FreeEnd>> next;

    /// The end that follows `end`; nullopt if none is near.
    std::optional<FreeEnd> next_of(const FreeEnd& end) const { return next[end.number()]; }
    /// Position of an end; world, mm.
    Vec3 position(const FreeEnd& end) const {
        const FreeEdge& edge = all[end.edge];
        return (end.last ? edge.places.back() : edge.places.front()).position;
    }
};

/// The free edges of a model with these seams. Edges up to `least` mm are left out. Ends without a
/// seam between them are joined within `join` mm, the nearest first.
FreeEdges free_edges(const BoundaryCurves& curves, std::span<const Seam> seams, double least,
                     double join, const Job& job = {});

} // namespace keiko
