#include "keiko/visibility/contours/contour_border.h"

#include "keiko/visibility/nets/tangent_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

Vec4 homogeneous(const Vec3& p, double w) {
    return {p.x * w, p.y * w, p.z * w, w};
}

/// Control points of a conic section through three places, tangent to the curve at its ends; a
/// parabola through them where there is none.
std::array<Vec4, 3> conic_through(const BorderCurve::Point& a, const Vec3& middle,
                                  const BorderCurve::Point& b) {
    const Vec3 chord = b.place - a.place, axis = a.along.cross(b.along);
    const double s = chord.cross(b.along).dot(axis) / axis.length2();
    const Vec3 to_corner = a.along * s, to_middle = middle - a.place;
    const Vec3 plane = to_corner.cross(chord);
    const double of_corner = to_middle.cross(chord).dot(plane) / plane.length2();
    const double of_end = to_corner.cross(to_middle).dot(plane) / plane.length2();
    const double of_begin = 1 - of_corner - of_end;
    if (of_corner > 0 && of_end > 0 && of_begin > 0)
        return {homogeneous(a.place, 4 * of_begin), homogeneous(a.place + to_corner, 2 * of_corner),
                homogeneous(b.place, 4 * of_end)};
    return {homogeneous(a.place, 1), homogeneous(middle * 2 - (a.place + b.place) / 2, 1),
            homogeneous(b.place, 1)};
}

/// A conic section in space as a point sees it.
ContourArc seen_from(const std::array<Vec4, 3>& control, const Vec3& point) {
    const auto way = [&](const Vec4& p) { return spatial(p) - point * p.w; };
    return {way(control[0]), way(control[1]), way(control[2])};
}

/// Parameter at which a conic section crosses the plane through a place beside it, across the chord
/// of its ends; nullopt if that is not one.
std::optional<double> parameter_beside(const std::array<Vec4, 3>& control, const Vec3& place) {
    const Vec3 chord = spatial(control[2]) / control[2].w - spatial(control[0]) / control[0].w;
    const ContourArc::Crossings level = seen_from(control, place).crossings(chord);
    return level.count == 1 ? std::optional(level.of[0].t) : std::nullopt;
}

/// Value at a share of the way of the polynomial through values at even steps (Neville's scheme).
template <std::size_t size>
double interpolated(std::array<double, size> values, double share) {
    const double x = share * (size - 1);
    for (std::size_t level = 1; level < size; ++level)
        for (std::size_t i = 0; i + level < size; ++i) {
            const double from = x - static_cast<double>(i);
            values[i] += (values[i + 1] - values[i]) * from / static_cast<double>(level);
        }
    return values[0];
}

/// Zero between two places with values of opposite signs, by the Illinois method.
template <class F>
double zero_between(const F& f, double low, double high, double f_low, double f_high) {
    constexpr int most_steps = 60;
    constexpr double enough = 1e-14;
    for (int i = 0; i < most_steps && high - low > enough; ++i) {
        const double x = low + (high - low) * f_low / (f_low - f_high), value = f(x);
        if (value == 0) return x;
        if ((value > 0) == (f_high > 0)) {
            if (high - x <= enough) return x;
            high = x, f_high = value, f_low /= 2;
        } else {
            if (x - low <= enough) return x;
            low = x, f_low = value, f_high /= 2;
        }
    }
    return (low + high) / 2;
}

/// Zero between two places near a first guess. `slope`: nearly that of the function there, so that
/// each step gains some digits. The guess where there is none, as beside a corner without a normal.
template <class F>
double polished(const F& f, double slope, double x, double low, double high) {
    constexpr double enough = 1e-13;
    constexpr int most_steps = 5;
    for (int i = 0; i < most_steps; ++i) {
        const double before = x, more = f(x) / slope;
        if (!std::isfinite(more)) break;
        x = std::clamp(x - more, low, high);
        if (std::abs(x - before) <= enough) break;
    }
    return x;
}

/// Tangent plane with a unit normal at a share of a part of a curve. At a corner that has none, a
/// little inside the part.
Vec4 unit_plane(const BorderSide& side, const ParameterInterval& part, double share) {
    constexpr double inside = 1e-3, aside = 0.25, singular = 1e-9; // of the part, the next normal
    const auto plane_at = [&](double s) { return side.plane(part.begin + part.length() * s); };
    const double inwards = share < 0.5 ? 1 : -1;
    const Vec4 plane = plane_at(share), next = plane_at(share + aside * inwards);
    if (spatial(plane).length() > singular * spatial(next).length())
        return plane / spatial(plane).length();
    const Vec4 nearby = plane_at(share + inside * inwards);
    const double length = spatial(nearby).length();
    return length > 0 ? nearby / length : Vec4(0);
}

/// Sheets that a face adds on the left of its border.
SheetCount left_of(const BorderSide& side, bool front) {
    return front ? SheetCount{-side.sense, 0} : SheetCount{0, side.sense};
}

} // namespace

ContourBorder::ContourBorder(BorderCurve curve, double deviation) : curve_(std::move(curve)) {
    constexpr int most_halvings = 12;
    double from = 0;
    std::vector<double> ends = curve_.kinks;
    ends.push_back(1);
    for (const double end : ends) {
        add_pieces({from, end}, deviation, most_halvings);
        from = end;
    }
}

ContourBorder::Heights ContourBorder::heights_over(const Planes& planes, const Vec3& point) {
    Heights heights;
    for (std::size_t k = 0; k < nodes; ++k)
        heights[k] = spatial(planes[k]).dot(point) + planes[k].w;
    return heights;
}

ContourBorder::Planes ContourBorder::planes_along(const BorderSide& side,
                                                  const ParameterInterval& part) const {
    Planes planes;
    for (std::size_t k = 0; k < nodes; ++k)
        planes[k] = unit_plane(side, part, static_cast<double>(k) / (nodes - 1));
    return planes;
}

bool ContourBorder::fits(const Piece& piece, double deviation) const {
    constexpr double widest_turn = 0.5; // rad, from node to node
    for (const Planes* planes : {&piece.own, &piece.other})
        for (std::size_t k = 0; k + 1 < nodes; ++k)
            if (angle_between(spatial((*planes)[k]), spatial((*planes)[k + 1])) > widest_turn)
                return false;
    const auto is_near = [&](double share) {
        const Vec3 at = curve_.at(piece.part.begin + share * piece.part.length()).place;
        const auto t = parameter_beside(piece.control, at);
        if (!t) return false;
        const double s = 1 - *t;
        const auto& [first, second, third] = piece.control;
        const double w = first.w * s * s + second.w * 2 * *t * s + third.w * *t * *t;
        return seen_from(piece.control, at).at(*t).length() <= deviation * w;
    };
    return is_near(0.25) && is_near(0.75);
}

void ContourBorder::add_pieces(const ParameterInterval& part, double deviation, int depth) {
    const double middle = (part.begin + part.end) / 2;
    const BorderCurve::Point a = curve_.at(part.begin), b = curve_.at(part.end);
    const Planes own = planes_along(curve_.own, part);
    const Piece piece{part,
                      conic_through(a, curve_.at(middle).place, b),
                      own,
                      curve_.other ? planes_along(*curve_.other, part) : own,
                      part.begin == 0 && curve_.turns_at_begin,
                      part.end == 1 && curve_.turns_at_end};
    if (depth == 0 || fits(piece, deviation)) return pieces_.push_back(piece);
    add_pieces({part.begin, middle}, deviation, depth - 1);
    add_pieces({middle, part.end}, deviation, depth - 1);
}

std::vector<double> ContourBorder::edge_on(const Piece& piece, const BorderSide& side,
                                           const Heights& heights, const Vec3& point) const {
    std::vector<double> shares;
    const auto about = [&](double share) { return interpolated(heights, share); };
    const auto height = [&](double share) {
        const Vec4 plane = side.plane(piece.part.begin + share * piece.part.length());
        return (spatial(plane).dot(point) + plane.w) / spatial(plane).length();
    };
    for (std::size_t k = 0; k + 1 < nodes; ++k) {
        if ((heights[k] >= 0) == (heights[k + 1] >= 0)) continue;
        const double low = static_cast<double>(k) / (nodes - 1), high = low + 1.0 / (nodes - 1);
        double share = zero_between(about, low, high, heights[k], heights[k + 1]);
        constexpr double step = 1e-3;
        const double slope = (about(share + step) - about(share - step)) / (2 * step);
        share = polished(height, slope, share, low, high);
        shares.push_back(share);
    }
    return shares;
}

std::vector<ContourBorder::Change> ContourBorder::changes(const Piece& piece, const Vec3& point,
                                                          const Heights& over_own,
                                                          const Heights& over_other) const {
    std::vector<Change> all;
    const auto add = [&](const BorderSide& side, const Heights& heights, bool of_own) {
        for (const double share : edge_on(piece, side, heights, point)) {
            const double at = piece.part.begin + share * piece.part.length();
            const auto t = parameter_beside(piece.control, curve_.at(at).place);
            all.push_back({t.value_or(share), of_own});
        }
    };
    add(curve_.own, over_own, true);
    if (curve_.other) add(*curve_.other, over_other, false);
    std::sort(all.begin(), all.end(), [](const Change& a, const Change& b) { return a.t < b.t; });
    all.push_back({1, true});
    return all;
}

void ContourBorder::append_arcs(const Piece& piece, const Vec3& point,
                                std::vector<ContourArc>& arcs) const {
    const Heights over_own = heights_over(piece.own, point);
    const Heights over_other = heights_over(piece.other, point);
    bool own_front = over_own[0] >= 0, other_front = over_other[0] >= 0;
    ContourArc arc = seen_from(piece.control, point);
    arc.turns_at_begin = piece.turns_at_begin, arc.turns_at_end = piece.turns_at_end;
    double from = 0;
    for (const Change& change : changes(piece, point, over_own, over_other)) {
        ContourArc part = arc.part(from, change.t);
        part.left = left_of(curve_.own, own_front);
        if (curve_.other) part.left += left_of(*curve_.other, other_front);
        if (part.left != SheetCount{} && change.t > from) arcs.push_back(part);
        from = change.t;
        bool& front = change.of_own ? own_front : other_front;
        front = !front;
    }
}

void ContourBorder::append_arcs(const Vec3& point, std::vector<ContourArc>& arcs) const {
    for (const Piece& piece : pieces_) append_arcs(piece, point, arcs);
}

} // namespace keiko
