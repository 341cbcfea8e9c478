#include "keiko/inspect/openings/opening.h"

#include "keiko/base/units.h"
#include "keiko/inspect/openings/free_edges.h"
#include "keiko/inspect/openings/near_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace keiko {
namespace {

/// Radians: corners of cut-outs and of panels have 90 degrees and more.
constexpr double opening_angle = degrees_to_radians(85);

/// The way along free edges from the end of a seam.
class Strand {
public:
    /// From `start` until an edge ends without a next one, to `reach` mm or to the end `back`.
    Strand(const FreeEdges& edges, FreeEnd start, FreeEnd back, double reach) : edges_(&edges) {
        for (;;) {
            parts_.push_back({start, length_});
            length_ += edges.all[start.edge].length();
            const FreeEnd far{start.edge, !start.last};
            if (far == back) closed_ = true;
            const auto next = edges.next_of(far);
            if (closed_ || !next || length_ >= reach) return;
            start = *next;
        }
    }

    double length() const { return length_; }
    /// The lowest number of its free edges.
    std::uint32_t lowest_edge() const {
        std::uint32_t lowest = parts_.front().from.edge;
        for (const Part& part : parts_) lowest = std::min(lowest, part.from.edge);
        return lowest;
    }
    /// It leads around a hole.
    bool closed() const { return closed_; }

    FreePlace at(double way) const {
        std::size_t i = parts_.size() - 1;
        while (i > 0 && parts_[i].begin > way) --i;
        const Part& part = parts_[i];
        const FreeEdge& edge = edges_->all[part.from.edge];
        const double along = way - part.begin;
        return edge.at(part.from.last ? edge.length() - along : along);
    }

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

class OpeningSearch {
public:
    OpeningSearch(const BoundaryCurves& curves, const FreeEdges& edges, const OpeningLimits& limits)
        : curves_(curves), edges_(edges), limits_(limits) {}

    std::vector<Opening> run(const std::vector<NearEdges>& near) {
        std::vector<Opening> found;
        for (std::uint32_t i = 0; i < edges_.next.size(); ++i) {
            const FreeEnd a{i / 2, i % 2 == 1};
            const std::optional<FreeEnd> b = edges_.next[i];
            if (!b || 2 * std::size_t{b->edge} + b->last < i) continue;
            if (const auto opening = from_end_of_seam(a, *b)) found.push_back(*opening);
        }
        for (const NearEdges& n : near) {
            const Opening between = opening(n.a, n.b, n.length);
            if (n.distance > limits_.closed && is_new(between, n.a.edge, n.b.edge))
                found.push_back(between);
        }
        return found;
    }

private:
    using Key = std::pair<std::uint32_t, std::uint32_t>; ///< two free edges, the lower one first

    std::optional<Opening> from_end_of_seam(FreeEnd start_a, FreeEnd start_b);
    std::optional<Opening> between(const Strand& a, const Strand& b, double reach) const;
    /// Both free edges at equal ways from the end of the seam.
    struct Across {
        FreePlace a, b;
        double distance() const { return (a.position - b.position).length(); }
    };
    bool over_a_gap(const Across& across) const;
    double touching(const Strand& a, const Strand& b, double reach) const;

    Opening opening(const FreePlace& a, const FreePlace& b, double length) const {
        const auto side = [&](const FreePlace& p) {
            const BoundaryInterval& on = edges_.all[p.edge].pieces[p.piece];
            return Opening::Side{on.instance, on.face};
        };
        return {.sides = {side(a), side(b)},
                .width = (a.position - b.position).length(),
                .width_bound = 2 * edges_.chord_error,
                .length = length,
                .place = (a.position + b.position) / 2};
    }

    /// No opening between the same free edges was found within opening_reach of it.
    bool is_new(const Opening& opening, std::uint32_t a, std::uint32_t b) {
        const Key key = std::minmax(a, b);
        const auto [begin, end] = found_.equal_range(key);
        const double near = opening_reach * limits_.join;
        if (std::any_of(begin, end, [&](const auto& other) {
                return (other.second - opening.place).length() <= near;
            }))
            return false;
        found_.emplace(key, opening.place);
        return true;
    }

    const BoundaryCurves& curves_;
    const FreeEdges& edges_;
    const OpeningLimits& limits_;
    std::multimap<Key, Vec3> found_; ///< places of openings by their free edges
    std::set<std::uint32_t> holes_;  ///< with an opening, by their lowest edges
};

/// How far from the end of the seam the edges go on as close as those of a seam.
double OpeningSearch::touching(const Strand& a, const Strand& b, double reach) const {
    const double step = limits_.closed;
    double way = 0;
    while (way + step < reach && Across{a.at(way + step), b.at(way + step)}.distance() <= step)
        way += step;
    return way;
}

/// Whether the way across leaves one of the faces and does not go straight into the other. It runs
/// beside both at the rim of a tube, and beside one in a notch at a crease.
bool OpeningSearch::over_a_gap(const Across& across) const {
    const Vec3 way = across.b.position - across.a.position;
    const auto entered = [&](const FreePlace& p, const Vec3& out) {
        const auto frame = curves_.curve(edges_.all[p.edge].pieces[p.piece]).frame(p.t);
        return frame ? out.dot(frame->inward) / out.length() : 1;
    };
    const auto [least, most] = std::minmax({entered(across.a, way), entered(across.b, -way)});
    constexpr double leaves = -0.5, enters = 0.8;
    return least <= leaves && most <= enters;
}

/// Nothing where one was found before in the same hole or near by between the same free edges.
std::optional<Opening> OpeningSearch::from_end_of_seam(FreeEnd start_a, FreeEnd start_b) {
    const double most = opening_reach * limits_.join;
    const Strand a(edges_, start_a, start_b, 4 * most), b(edges_, start_b, start_a, 4 * most);
    // Twice as long as those that are followed all around: each is listed once.
    const bool hole = a.closed() && a.length() <= 4 * most;
    if (hole && holes_.count(a.lowest_edge()) > 0) return std::nullopt;
    const double reach = std::min({most, hole ? a.length() / 2 : most, a.length(), b.length()});
    std::optional<Opening> found = between(a, b, reach);
    if (!found || !is_new(*found, start_a.edge, start_b.edge)) return std::nullopt;
    constexpr double nearly_all = 0.95;
    found->goes_on = reach >= most && found->length >= nearly_all * most;
    if (hole) holes_.insert(a.lowest_edge());
    return found;
}

std::optional<Opening> OpeningSearch::between(const Strand& a, const Strand& b,
                                              double reach) const {
    const double from = touching(a, b, reach);
    const double narrow = 2 * std::sin(opening_angle / 2);
    constexpr double growth = 1.05;
    std::optional<Across> widest;
    double length = 0;
    for (double way = std::min(limits_.negligible, (reach - from) / 4); way <= reach - from;
         way *= growth) {
        const Across across{a.at(from + way), b.at(from + way)};
        const double distance = across.distance();
        if (distance > narrow * way || distance <= limits_.closed || !over_a_gap(across)) continue;
        length = way;
        if (!widest || distance > widest->distance()) widest = across;
    }
    if (!widest) return std::nullopt;
    return opening(widest->a, widest->b, length);
}

} // namespace

std::vector<Opening> find_openings(const SurfaceModel& model, std::span<const Seam> seams,
                                   const OpeningLimits& limits, const Job& job) {
    const BoundaryCurves curves(model);
    const FreeEdges edges = free_edges(model, curves, seams, limits.closed, limits.join, job);
    return OpeningSearch(curves, edges, limits).run(near_edges(edges, limits.join, job));
}

} // namespace keiko
