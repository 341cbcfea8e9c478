#include "keiko/inspect/openings/opening.h"

#include "keiko/base/units.h"
#include "keiko/inspect/openings/hole_form.h"
#include "keiko/inspect/openings/near_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace keiko {
namespace {

/// Distance to which the outline of a hole is followed, in join distances.
constexpr double longest_outline = 6 * opening_reach;

/// Radians: corners of cut-outs and of panels have 90 degrees and more.
constexpr double opening_angle = degrees_to_radians(85);

class OpeningSearch {
public:
    OpeningSearch(const BoundaryCurves& curves, const FreeEdges& edges, const OpeningLimits& limits)
        : curves_(curves), edges_(edges), limits_(limits) {}

    std::vector<Opening> run(const std::vector<NearEdges>& near) {
        std::vector<Opening> found;
        for (std::uint32_t i = 0; i < edges_.next.size(); ++i) {
            const std::optional<FreeEnd> b = edges_.next[i];
            if (!b || b->number() < i) continue;
            if (const auto opening = from_end_of_seam(FreeEnd::of_number(i), *b))
                found.push_back(*opening);
        }
        for (const NearEdges& n : near) {
            const Opening between = opening(n.a, n.b, n.length);
            if (n.distance > limits_.gap && is_new(between, n.a.edge, n.b.edge))
                found.push_back(between);
        }
        return found;
    }

private:
    using Key = std::pair<std::uint32_t, std::uint32_t>; ///< two free edges, the lower one first

    std::optional<Opening> from_end_of_seam(FreeEnd start_a, FreeEnd start_b);
    std::optional<Opening> around_hole(const Strand& a, const Strand& b, double reach) const;
    std::optional<Opening> between(const Strand& a, const Strand& b, double reach,
                                   bool in_hole) const;
    /// Places on both free edges at equal distances from the end of the seam.
    struct Across {
        FreePlace a, b;
        double distance() const { return (a.position - b.position).length(); }
    };
    std::optional<Across> widest(const std::vector<Across>& over, const Strand& a,
                                 const Strand& b) const;
    bool over_a_gap(const Across& across) const;
    Vec3 inward(const FreePlace& p) const;
    double touching(const Strand& a, const Strand& b, double reach) const;

    Opening opening(const FreePlace& a, const FreePlace& b, double length) const {
        const auto side = [&](const FreePlace& p) {
            const BoundaryInterval& on = edges_.all[p.edge].pieces[p.piece];
            return PlacedFace{on.instance, on.face};
        };
        return {.sides = {side(a), side(b)},
                .width = (a.position - b.position).length(),
                .width_bound = edges_.all[a.edge].deviation + edges_.all[b.edge].deviation,
                .length = length,
                .place = (a.position + b.position) / 2};
    }

    /// True if no opening between the same free edges was found within opening_reach of it.
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

/// Distance from the end of the seam along which the edges stay as close as those of a seam.
double OpeningSearch::touching(const Strand& a, const Strand& b, double reach) const {
    const double step = limits_.gap;
    double way = 0;
    while (way + step < reach && Across{a.at(way + step), b.at(way + step)}.distance() <= step)
        way += step;
    return way;
}

/// True if the connection between the edges spans a gap. It then leaves one of the faces and does
/// not go straight into the other, or runs beside two faces on either side of it, as where one
/// border rises from the other. At the rim of a tube it runs beside both on one side, and in a
/// notch at a crease beside one.
bool OpeningSearch::over_a_gap(const Across& across) const {
    const Vec3 way = across.b.position - across.a.position;
    const Vec3 a = inward(across.a), b = inward(across.b);
    const auto [least, most] = std::minmax({way.dot(a) / way.length(), -way.dot(b) / way.length()});
    constexpr double leaves = -0.5, enters = 0.8, opposite = -0.5;
    if (least > leaves && most < -leaves) return a.dot(b) < opposite;
    return least <= leaves && most <= enters;
}

/// Unit direction into the face at a free edge; 0 if unknown.
Vec3 OpeningSearch::inward(const FreePlace& p) const {
    const auto frame = curves_.curve(edges_.all[p.edge].pieces[p.piece]).frame(p.t);
    return frame ? frame->inward : Vec3(0);
}

/// Opening from the end of a seam; nullopt if one was found before in the same hole or near by
/// between the same free edges.
std::optional<Opening> OpeningSearch::from_end_of_seam(FreeEnd start_a, FreeEnd start_b) {
    const double most = opening_reach * limits_.join;
    const double follow = longest_outline * limits_.join;
    const Strand a(edges_, start_a, start_b, follow), b(edges_, start_b, start_a, follow);
    const bool hole = a.closed() && a.length() <= follow;
    if (hole && holes_.count(a.lowest_edge()) > 0) return std::nullopt;
    const double reach = std::min({most, hole ? a.length() / 2 : most, a.length(), b.length()});
    std::optional<Opening> found = hole ? around_hole(a, b, reach) : between(a, b, reach, false);
    if (!found || !is_new(*found, start_a.edge, start_b.edge)) return std::nullopt;
    if (hole) holes_.insert(a.lowest_edge());
    return found;
}

/// The opening that is a hole; `a` leads around it in one direction and `b` in the other.
std::optional<Opening> OpeningSearch::around_hole(const Strand& a, const Strand& b,
                                                  double reach) const {
    const std::optional<HoleForm> form = hole_form(curves_, edges_, a);
    const bool in_hole = form && form->is_within_faces();
    const bool small = a.length() <= 2 * opening_reach * limits_.join;
    const bool measurable = form && form->width > limits_.gap;
    if (!(small && in_hole && measurable)) {
        std::optional<Opening> found = between(a, b, reach, in_hole);
        if (!found || !measurable) return found;
    }
    Opening found = opening(a.at(a.length() / 4), b.at(b.length() / 4), form->length);
    found.width = form->width, found.width_bound = 2 * a.deviation();
    found.place = form->middle;
    return found;
}

/// Opening between two strands. `in_hole`: the area between them is known to be no material.
std::optional<Opening> OpeningSearch::between(const Strand& a, const Strand& b, double reach,
                                              bool in_hole) const {
    const double from = touching(a, b, reach);
    const double narrow = 2 * std::sin(opening_angle / 2);
    constexpr double growth = 1.05, nearly_all = 0.95;
    std::vector<Across> over;
    double length = 0;
    for (double way = std::min(limits_.from, (reach - from) / 4); way <= reach - from;
         way *= growth) {
        const Across across{a.at(from + way), b.at(from + way)};
        const double distance = across.distance();
        if (distance > narrow * way || distance <= limits_.gap) continue;
        if (in_hole || over_a_gap(across)) length = way, over.push_back(across);
    }
    const std::optional<Across> most = widest(over, a, b);
    if (!most) return std::nullopt;
    Opening found = opening(most->a, most->b, length);
    const double whole = opening_reach * limits_.join;
    found.goes_on = reach >= whole && length >= nearly_all * whole;
    return found;
}

/// The largest of the distances from either side to the nearest place of the other.
std::optional<OpeningSearch::Across> OpeningSearch::widest(const std::vector<Across>& over,
                                                           const Strand& a, const Strand& b) const {
    if (over.empty()) return std::nullopt;
    // Each up to half of an outline that is closed or longer than the strands.
    const auto side = [&](const Strand& s) {
        return s.places(s.closed() ? s.length() / 2 : longest_outline * limits_.join / 2);
    };
    const std::vector<FreePlace> side_a = side(a), side_b = side(b);
    std::optional<Across> widest;
    const auto consider = [&](const Across& across) {
        if (across.distance() <= limits_.gap) return;
        if (!widest || across.distance() > widest->distance()) widest = across;
    };
    for (const Across& across : over) {
        consider({across.a, nearest_place(side_b, across.a.position)});
        consider({nearest_place(side_a, across.b.position), across.b});
    }
    return widest;
}

} // namespace

std::vector<Opening> find_openings(const BoundaryCurves& curves, const FreeEdges& edges,
                                   const OpeningLimits& limits, const Job& job) {
    return OpeningSearch(curves, edges, limits).run(near_edges(edges, limits.join, job));
}

} // namespace keiko
