#include "keiko/inspect/openings/hole_form.h"

#include "keiko/geometry/model/closest_point.h"
#include "keiko/math/axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

Vec3 centroid_of(const std::vector<FreePlace>& outline) {
    Vec3 sum{0};
    double length = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec3 &p = outline[i].position, &q = outline[(i + 1) % outline.size()].position;
        sum += (p + q) / 2 * (q - p).length();
        length += (q - p).length();
    }
    return sum / length;
}

/// Normal of the outline, with the enclosed area as its length.
Vec3 area_of(const std::vector<FreePlace>& outline, const Vec3& middle) {
    Vec3 area{0};
    for (std::size_t i = 0; i < outline.size(); ++i)
        area += (outline[i].position - middle)
                    .cross(outline[(i + 1) % outline.size()].position - middle) /
                2;
    return area;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Convex hull, counter-clockwise.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec2> hull;
    for (const bool back : {false, true}) {
        const std::size_t begin = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        if (!back) std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// Width and length of the narrowest rectangle around a convex polygon: one of its sides lies on
/// the rectangle.
void measure(const std::vector<Vec2>& hull, HoleForm& form) {
    form.width = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 &p = hull[i], &q = hull[(i + 1) % hull.size()];
        const double side = std::hypot(q.x - p.x, q.y - p.y);
        double breadth = 0, least = 0, most = 0;
        for (const Vec2& r : hull) {
            breadth = std::max(breadth, turn(p, q, r) / side);
            const double along = ((r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y)) / side;
            least = std::min(least, along), most = std::max(most, along);
        }
        if (breadth < form.width) form.width = breadth, form.length = most - least;
    }
}

void add_sides(const BoundaryCurves& curves, const FreeEdges& edges,
               const std::vector<FreePlace>& outline, HoleForm& form) {
    double weight = 0;
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        const FreePlace &p = outline[i], &q = outline[i + 1];
        const Vec3 chord = q.position - p.position;
        if (p.edge != q.edge || p.piece != q.piece || chord.length() == 0) continue;
        const auto frame = curves.curve(edges.all[p.edge].pieces[p.piece]).frame((p.t + q.t) / 2);
        Vec3 out = (p.position + q.position) / 2 - form.middle;
        out -= chord * (out.dot(chord) / chord.dot(chord));
        if (!frame) continue;
        weight += out.length() * chord.length();
        const double share = out.dot(frame->inward) * chord.length();
        (share > 0 ? form.away : form.nearer) += std::abs(share);
    }
    if (weight > 0) form.away /= weight, form.nearer /= weight;
}

} // namespace

Strand::Strand(const FreeEdges& edges, FreeEnd start, FreeEnd back, double reach) : edges_(&edges) {
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

std::uint32_t Strand::lowest_edge() const {
    std::uint32_t lowest = parts_.front().from.edge;
    for (const Part& part : parts_) lowest = std::min(lowest, part.from.edge);
    return lowest;
}

double Strand::deviation() const {
    double largest = 0;
    for (const Part& part : parts_)
        largest = std::max(largest, edges_->all[part.from.edge].deviation);
    return largest;
}

FreePlace Strand::at(double way) const {
    std::size_t i = parts_.size() - 1;
    while (i > 0 && parts_[i].begin > way) --i;
    const Part& part = parts_[i];
    const FreeEdge& edge = edges_->all[part.from.edge];
    const double along = way - part.begin;
    return edge.at(part.from.last ? edge.length() - along : along);
}

std::vector<FreePlace> Strand::places(double until) const {
    std::vector<FreePlace> corners;
    for (const Part& part : parts_) {
        const FreeEdge& edge = edges_->all[part.from.edge];
        const std::size_t count = edge.places.size();
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = part.from.last ? count - 1 - k : k;
            const double along = part.from.last ? edge.length() - edge.ways[i] : edge.ways[i];
            if (part.begin + along >= until) {
                corners.push_back(at(until));
                return corners;
            }
            corners.push_back(edge.places[i]);
        }
    }
    return corners;
}

FreePlace nearest_place(const std::vector<FreePlace>& line, const Vec3& p) {
    FreePlace best = line.front();
    double least = (best.position - p).length();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 &from = line[i].position, &to = line[i + 1].position;
        const double share = nearest_on_segment(from, to, p);
        const Vec3 foot = from + (to - from) * share;
        if (const double distance = (foot - p).length(); distance < least) {
            least = distance, best = line[share < 0.5 ? i : i + 1];
            best.position = foot;
        }
    }
    return best;
}

bool HoleForm::is_within_faces() const {
    constexpr double taper = 0.25; // sine of 14 degrees: tubes narrow this much towards their rims
    constexpr double one_side = 0.4, level = 0.9;
    return away - nearer >= taper || (away >= one_side && away >= level * nearer);
}

std::optional<HoleForm> hole_form(const BoundaryCurves& curves, const FreeEdges& edges,
                                  const Strand& outline) {
    const std::vector<FreePlace> places = outline.places(outline.length());
    HoleForm form;
    form.middle = centroid_of(places);
    const Vec3 area = area_of(places, form.middle);
    constexpr double nothing = 1e-6;
    if (!(area.length() > nothing * outline.length() * outline.length())) return std::nullopt;
    const Vec3 normal = area / area.length(), u = any_perpendicular(normal).normalized(),
               v = normal.cross(u);
    std::vector<Vec2> points;
    points.reserve(places.size());
    double low = 0, high = 0;
    for (const FreePlace& place : places) {
        points.emplace_back(place.position.dot(u), place.position.dot(v));
        const double height = (place.position - form.middle).dot(normal);
        low = std::min(low, height), high = std::max(high, height);
    }
    form.depth = high - low, form.area = area.length();
    measure(convex_hull(std::move(points)), form);
    add_sides(curves, edges, places, form);
    return form;
}

} // namespace keiko
