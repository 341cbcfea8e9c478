#include "keiko/inspect/openings/torn_edges.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/model/closest_point.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace keiko {
namespace {

/// A border along an edge, with its polyline.
struct Side {
    SurfaceCurve curve;
    CurvePolyline coarse;
};

/// An edge as one instance places it, with one face and another that share it.
using EdgeSides = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

/// Whether a distance is more than another and its rounding: of a uniform gap the first place
/// counts.
bool is_wider(double distance, double than) {
    constexpr double rounding = 1e-9;
    return distance > than * (1 + rounding);
}

class TornEdgeSearch {
public:
    TornEdgeSearch(const SurfaceModel& model, const BoundaryCurves& curves, double join)
        : model_(model), curves_(curves), uses_(edge_uses(model)), join_(join) {}

    /// The torn edges along one free piece, by the face on the other side.
    std::map<EdgeSides, TornEdge> along(const BoundaryInterval& piece) const {
        std::map<EdgeSides, TornEdge> torn;
        if (piece.curve >= natural_side) return torn;
        const std::uint32_t edge = model_.trim_curves[piece.curve].edge;
        if (edge == no_index || model_.edges[edge].degenerate) return torn;
        for (const auto& [face, sides] : other_sides(piece, uses_[edge])) {
            TornEdge found = compare(piece, sides);
            if (!(found.length > 0)) continue;
            found.sides = {PlacedFace{piece.instance, piece.face}, {piece.instance, face}};
            torn.emplace(EdgeSides{piece.instance, edge, piece.face, face}, found);
        }
        return torn;
    }

private:
    /// The borders of each other face along the edge of a piece. A face that is alone with its edge
    /// has its own other borders there: a closed surface meets itself.
    std::map<std::uint32_t, std::vector<Side>> other_sides(const BoundaryInterval& piece,
                                                           const std::vector<EdgeUse>& uses) const {
        const bool alone = std::all_of(uses.begin(), uses.end(),
                                       [&](const EdgeUse& use) { return use.face == piece.face; });
        std::map<std::uint32_t, std::vector<Side>> sides;
        for (const EdgeUse& use : uses) {
            const bool own = piece.curve - use.first_curve < use.curve_count;
            if (own || (use.face == piece.face && !alone)) continue;
            for (std::uint32_t i = 0; i < use.curve_count; ++i) {
                const SurfaceCurve curve =
                    curves_.curve({piece.instance, use.face, use.first_curve + i, 0, 1});
                sides[use.face].push_back({curve, make_polyline(curve, join_ / 10)});
            }
        }
        return sides;
    }

    /// Distance of a place from the nearest of some borders, and that place.
    static std::pair<double, Vec3> nearest(const Vec3& p, const std::vector<Side>& sides) {
        const auto side =
            std::min_element(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
                return a.coarse.distance(p) < b.coarse.distance(p);
            });
        const ClosestPoint foot = closest_point(side->curve, p, side->coarse.nearest(p));
        return {foot.distance, foot.point.position};
    }

    TornEdge compare(const BoundaryInterval& piece, const std::vector<Side>& sides) const {
        const SurfaceCurve own = curves_.curve(piece);
        const double length = own.length(piece.begin, piece.end);
        constexpr double most_steps = 10000;
        const int steps =
            static_cast<int>(std::clamp(std::ceil(4 * length / join_), 4.0, most_steps));
        TornEdge torn;
        for (int i = 0; i < steps; ++i) {
            const double t = piece.begin + (piece.end - piece.begin) * (i + 0.5) / steps;
            const Vec3 p = own.at(t).position;
            const auto [distance, q] = nearest(p, sides);
            if (!(distance > join_)) continue;
            torn.length += length / steps;
            if (is_wider(distance, torn.distance))
                torn.distance = distance, torn.place = (p + q) / 2;
        }
        return torn;
    }

    const SurfaceModel& model_;
    const BoundaryCurves& curves_;
    std::vector<std::vector<EdgeUse>> uses_;
    double join_;
};

void add(TornEdge& to, const TornEdge& piece) {
    const double length = to.length + piece.length;
    if (is_wider(piece.distance, to.distance)) to = piece;
    to.length = length;
}

/// Both sides of an edge find it torn: one stays, at the larger distance.
std::vector<TornEdge> once_each(const std::map<EdgeSides, TornEdge>& torn,
                                const std::vector<EdgeSides>& order, double least) {
    std::vector<TornEdge> result;
    for (const EdgeSides& sides : order) {
        const auto& [instance, edge, own, other] = sides;
        const TornEdge& here = torn.at(sides);
        const auto there = torn.find({instance, edge, other, own});
        if (!(here.length > least)) continue;
        const bool both = own != other && there != torn.end() && there->second.length > least;
        if (!both || is_wider(here.distance, there->second.distance) ||
            (own < other && !is_wider(there->second.distance, here.distance)))
            result.push_back(here);
    }
    return result;
}

} // namespace

std::vector<TornEdge> torn_edges(const SurfaceModel& model, const BoundaryCurves& curves,
                                 const FreeEdges& edges, double join, double least,
                                 const Job& job) {
    const TornEdgeSearch search(model, curves, join);
    std::vector<BoundaryInterval> pieces;
    for (const FreeEdge& edge : edges.all)
        pieces.insert(pieces.end(), edge.pieces.begin(), edge.pieces.end());
    std::vector<std::map<EdgeSides, TornEdge>> of_pieces(pieces.size());
    parallel_for(pieces.size(), job, "",
                 [&](std::size_t i) { of_pieces[i] = search.along(pieces[i]); });
    std::map<EdgeSides, TornEdge> torn;
    std::vector<EdgeSides> order;
    for (const auto& of_piece : of_pieces)
        for (const auto& [sides, found] : of_piece) {
            const auto [known, is_new] = torn.try_emplace(sides, found);
            if (is_new)
                order.push_back(sides);
            else
                add(known->second, found);
        }
    return once_each(torn, order, least);
}

} // namespace keiko
