#include "keiko/inspect/openings/free_edges.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace keiko {
namespace {

/// mm: largest distance of the polyline of a free edge from the edge.
constexpr double chord_error = 0.002;

using BorderKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

BorderKey key_of(const BoundaryInterval& on) {
    return {on.instance, on.face, on.curve};
}

/// The parts of each border that belong to seams.
using CoveredBorders = std::map<BorderKey, IntervalSet>;

CoveredBorders covered_borders(std::span<const Seam> seams) {
    std::map<BorderKey, std::vector<ParameterInterval>> parts;
    for (const Seam& seam : seams)
        for (const BoundaryInterval* on : {&seam.a, &seam.b})
            parts[key_of(*on)].push_back(
                {std::min(on->begin, on->end), std::max(on->begin, on->end)});
    CoveredBorders covered;
    for (auto& [key, intervals] : parts) covered[key] = IntervalSet(std::move(intervals));
    return covered;
}

/// Pieces of one free edge, and whether it is the whole loop.
struct Run {
    std::vector<BoundaryInterval> pieces;
    bool closed = false;
};

IntervalSet free_parts(const BoundaryInterval& border, const CoveredBorders& covered) {
    const auto found = covered.find(key_of(border));
    return found == covered.end() ? IntervalSet::whole() : found->second.complement();
}

/// Joins the last and the first run of a loop that begins inside a free edge.
void join_ends(std::vector<Run>& runs) {
    if (runs.size() == 1) {
        runs.front().closed = true;
        return;
    }
    auto& last = runs.back().pieces;
    last.insert(last.end(), runs.front().pieces.begin(), runs.front().pieces.end());
    runs.erase(runs.begin());
}

/// The free runs of one loop.
std::vector<Run> free_runs(const std::vector<BoundaryInterval>& loop,
                           const CoveredBorders& covered) {
    std::vector<Run> runs;
    bool goes_on = false;
    for (BoundaryInterval border : loop) {
        const IntervalSet free = free_parts(border, covered);
        if (free.empty() || free[0].begin > 0) goes_on = false;
        for (const ParameterInterval& part : free) {
            if (!goes_on || part.begin > 0) runs.emplace_back();
            border.begin = part.begin, border.end = part.end;
            runs.back().pieces.push_back(border);
            goes_on = part.end == 1;
        }
    }
    if (!goes_on) return runs;
    const BoundaryInterval& first = runs.front().pieces.front();
    if (first.curve == loop.front().curve && first.begin == 0) join_ends(runs);
    return runs;
}

FreeEdge edge_of(const BoundaryCurves& curves, Run run) {
    FreeEdge edge{std::move(run.pieces), {}, {}, 0, run.closed};
    const auto add = [&](const FreePlace& place) {
        if (edge.places.empty())
            edge.ways.push_back(0);
        else
            edge.ways.push_back(edge.length() +
                                (place.position - edge.places.back().position).length());
        edge.places.push_back(place);
    };
    for (std::uint32_t i = 0; i < edge.pieces.size(); ++i) {
        const BoundaryInterval& piece = edge.pieces[i];
        const SurfaceCurve curve = curves.curve(piece);
        const CurvePolyline line = make_polyline(curve, chord_error);
        edge.deviation = std::max({edge.deviation, chord_error, line.deviation});
        add({0, i, piece.begin, curve.at(piece.begin).position});
        for (std::size_t k = 0; k < line.t.size(); ++k)
            if (line.t[k] > piece.begin && line.t[k] < piece.end)
                add({0, i, line.t[k], line.points[k]});
        add({0, i, piece.end, curve.at(piece.end).position});
    }
    return edge;
}

/// Joins the ends of free edges.
class Joining {
public:
    explicit Joining(FreeEdges& edges) : edges_(edges), tree_(boxes_of_ends(edges)) {}

    /// Joins the ends beside those of seams.
    void join_beside(const BoundaryCurves& curves, std::span<const Seam> seams, double near) {
        for (const Seam& seam : seams)
            for (const bool at_end : {false, true}) {
                const auto a = end_near(curves, seam.a, at_end, near);
                const auto b = end_near(curves, seam.b, at_end, near);
                if (a && b && *a != *b) join(*a, *b);
            }
    }

    /// Joins the other ends, the nearest first.
    void join_rest(double near) {
        struct Pair {
            double distance;
            std::uint32_t i, j;
        };
        std::vector<Pair> pairs;
        for (std::uint32_t i = 0; i < edges_.next.size(); ++i) {
            if (edges_.next[i] || edges_.all[i / 2].closed) continue;
            const Vec3 from = position(i);
            for (const std::uint32_t j : ends_about(from, near))
                if (const double d = (position(j) - from).length();
                    j > i && !edges_.next[j] && d <= near && may_meet(i, j, d))
                    pairs.push_back({d, i, j});
        }
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const Pair& x, const Pair& y) { return x.distance < y.distance; });
        for (const Pair& pair : pairs) join(pair.i, pair.j);
    }

private:
    Vec3 position(std::uint32_t end) const { return edges_.position(FreeEnd::of_number(end)); }

    /// Ends of edges within a box of `near` mm around a place.
    std::vector<std::uint32_t> ends_about(const Vec3& place, double near) const {
        Box3 box;
        box.extend(place);
        return tree_.overlapping(box.padded(near));
    }

    static std::vector<Box3> boxes_of_ends(const FreeEdges& edges) {
        std::vector<Box3> boxes(2 * edges.all.size());
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            if (!edges.all[i / 2].closed) boxes[i].extend(edges.position(FreeEnd::of_number(i)));
        return boxes;
    }

    /// True if two ends may meet; the ends of one edge do only if it leads away between them.
    bool may_meet(std::uint32_t i, std::uint32_t j, double distance) const {
        return i / 2 != j / 2 || edges_.all[i / 2].length() > 4 * distance;
    }

    void join(std::uint32_t i, std::uint32_t j) {
        if (edges_.next[i] || edges_.next[j]) return;
        edges_.next[i] = FreeEnd::of_number(j), edges_.next[j] = FreeEnd::of_number(i);
    }

    std::optional<std::uint32_t> end_near(const BoundaryCurves& curves, const BoundaryInterval& on,
                                          bool at_end, double near) const {
        const Vec3 place = curves.curve(on).at(at_end ? on.end : on.begin).position;
        std::optional<std::uint32_t> best;
        for (const std::uint32_t i : ends_about(place, near)) {
            const PlacedFace face{on.instance, on.face};
            if (edges_.next[i] || edges_.all[i / 2].face() != face) continue;
            const double d = (position(i) - place).length();
            if (d > near) continue;
            if (!best || d < (position(*best) - place).length()) best = i;
        }
        return best;
    }

    FreeEdges& edges_;
    BoxTree tree_;
};

} // namespace

FreePlace FreeEdge::at(double way) const {
    const auto beyond = std::upper_bound(ways.begin() + 1, ways.end() - 1, way);
    const auto i = static_cast<std::size_t>(beyond - ways.begin());
    const FreePlace &p = places[i - 1], &q = places[i];
    const double span = ways[i] - ways[i - 1];
    const double share = span > 0 ? std::clamp((way - ways[i - 1]) / span, 0.0, 1.0) : 0;
    FreePlace result = p.piece == q.piece ? p : q;
    if (p.piece == q.piece) result.t += share * (q.t - p.t);
    result.position = p.position + (q.position - p.position) * share;
    return result;
}

FreeEdges free_edges(const BoundaryCurves& curves, std::span<const Seam> seams, double least,
                     double join, const Job& job) {
    const CoveredBorders covered = covered_borders(seams);
    const auto loops = curves.loops();
    std::vector<std::vector<FreeEdge>> found(loops.size());
    parallel_for(loops.size(), job, "", [&](std::size_t i) {
        for (Run& run : free_runs(loops[i], covered)) {
            FreeEdge edge = edge_of(curves, std::move(run));
            if (edge.length() > least) found[i].push_back(std::move(edge));
        }
    });
    FreeEdges result;
    for (auto& edges : found)
        for (FreeEdge& edge : edges) {
            for (FreePlace& place : edge.places)
                place.edge = static_cast<std::uint32_t>(result.all.size());
            result.all.push_back(std::move(edge));
        }
    result.next.resize(2 * result.all.size());
    Joining joining(result);
    joining.join_beside(curves, seams, join / 10);
    joining.join_rest(join);
    return result;
}

} // namespace keiko
