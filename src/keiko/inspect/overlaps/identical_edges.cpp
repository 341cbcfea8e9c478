#include "keiko/inspect/overlaps/identical_edges.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/inspect/structure/edge_runs.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// An edge as one of its faces has it, and all faces that have it.
struct PlacedEdge {
    EdgeSide run;
    std::vector<PlacedFace> faces; ///< one a side; a face that it bounds twice occurs twice
    std::vector<Vec3> places;      ///< world, mm
    Box3 box;                      ///< of these
};

std::vector<PlacedEdge> placed_edges(const ModelBorders& borders) {
    std::vector<PlacedEdge> edges;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers;
    for (EdgeSide& run : edge_runs(borders)) {
        if (run.edge == no_index) continue;
        const PlacedFace face = run.face;
        const auto [known, is_new] = numbers.try_emplace({face.instance, run.edge}, edges.size());
        if (is_new) {
            edges.push_back({std::move(run), {}, {}, {}});
            edges.back().places = border_places(borders.curves, edges.back().run.curves);
            for (const Vec3& p : edges.back().places) edges.back().box.extend(p);
        }
        edges[known->second].faces.push_back(face);
    }
    return edges;
}

/// True for the two sides of a seam that the file does not join.
bool are_unjoined_sides(const PlacedEdge& a, const PlacedEdge& b) {
    return a.faces.size() == 1 && b.faces.size() == 1 && !(a.faces[0] == b.faces[0]);
}

/// The curves of an edge, prepared for the nearest of their places.
class NearEdge {
public:
    NearEdge(const BoundaryCurves& curves, const EdgeSide& run, double chord_error) {
        for (const BoundaryInterval& border : run.curves) {
            curves_.push_back(curves.curve(border));
            lines_.push_back(make_polyline(curves_.back(), chord_error));
        }
    }
    /// mm from a place to the nearest of the curves.
    double distance(const Vec3& p) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < curves_.size(); ++i)
            least = std::min(least, closest_point(curves_[i], p, lines_[i].nearest(p)).distance);
        return least;
    }

private:
    std::vector<SurfaceCurve> curves_;
    std::vector<CurvePolyline> lines_;
};

std::optional<IdenticalEdges> lying_on(const BoundaryCurves& curves, const PlacedEdge& edge,
                                       const PlacedEdge& other, double limit) {
    IdenticalEdges found;
    found.faces = {edge.faces.front(), other.faces.front()}, found.limit = limit;
    const NearEdge near(curves, other.run, limit);
    for (const Vec3& p : edge.places) {
        const double distance = near.distance(p);
        if (!(distance <= limit)) return std::nullopt;
        if (distance < found.distance) continue;
        found.distance = distance, found.place = p;
    }
    found.length = polyline_length(curves, edge.run, 8);
    return found;
}

/// Edges that lie on others, by the numbers of both.
using Pairs = std::map<std::pair<std::size_t, std::size_t>, IdenticalEdges>;

std::vector<IdenticalEdges> each_once(const std::vector<Pairs>& of_edges) {
    Pairs all;
    for (const Pairs& some : of_edges) all.insert(some.begin(), some.end());
    std::vector<IdenticalEdges> edges;
    for (const auto& [numbers, pair] : all) edges.push_back(pair);
    return edges;
}

} // namespace

std::vector<IdenticalEdges> identical_edges(const ModelBorders& borders, const FaceLimits& limits,
                                            const Job& job) {
    const std::vector<PlacedEdge> edges = placed_edges(borders);
    std::vector<Box3> boxes;
    for (const PlacedEdge& edge : edges) boxes.push_back(edge.box);
    const BoxTree tree(std::move(boxes));
    std::vector<Pairs> found(edges.size());
    parallel_for(edges.size(), job, "", [&](std::size_t i) {
        const PlacedEdge& edge = edges[i];
        const auto& limit = limits.of(edge.faces.front()).structure.identical_edge;
        if (!limit || edge.box.size() <= 2 * *limit) return;
        for (const std::uint32_t k : tree.overlapping(edge.box.padded(*limit))) {
            const PlacedEdge& other = edges[k];
            const Box3 around = other.box.padded(*limit);
            if (!around.contains(edge.box.lower) || !around.contains(edge.box.upper)) continue;
            if (k == i || other.run.face.instance != edge.run.face.instance) continue;
            if (!limits.in_scope(edge.faces.front(), other.faces.front())) continue;
            if (are_unjoined_sides(edge, other)) continue;
            const std::pair<std::size_t, std::size_t> numbers = std::minmax<std::size_t>(i, k);
            if (const auto pair = lying_on(borders.curves, edge, other, *limit))
                found[i].emplace(numbers, *pair);
        }
    });
    return each_once(found);
}

} // namespace keiko
