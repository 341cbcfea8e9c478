#include "keiko/geometry/bezier/interpolation.h"

#include <algorithm>
#include <cassert>

namespace keiko {
namespace {

/// Points that differ from the one before, and the chord lengths up to each.
struct ChordLengths {
    std::vector<Vec3> points;
    std::vector<double> along; ///< mm

    double step(std::size_t i) const { return along[i + 1] - along[i]; }
    Vec3 slope(std::size_t i) const { return (points[i + 1] - points[i]) / step(i); }
};

ChordLengths chord_lengths(std::span<const Vec3> points) {
    ChordLengths chords;
    for (const Vec3& point : points) {
        const double step = chords.points.empty() ? 0 : (point - chords.points.back()).length();
        const double along = chords.along.empty() ? 0 : chords.along.back() + step;
        if (!chords.along.empty() && !(along > chords.along.back())) continue;
        chords.points.push_back(point);
        chords.along.push_back(along);
    }
    assert(chords.points.size() > 1);
    return chords;
}

InterpolatedCurve polyline(const ChordLengths& chords) {
    InterpolatedCurve line;
    line.curve.degree = 1;
    line.curve.knots = chords.along;
    line.curve.knots.insert(line.curve.knots.begin(), chords.along.front());
    line.curve.knots.push_back(chords.along.back());
    for (const Vec3& point : chords.points)
        line.curve.points.emplace_back(point.x, point.y, point.z, 1);
    return line;
}

/// The derivative by length at the points: those of a twice continuous cubic spline.
std::vector<Vec3> spline_tangents(const ChordLengths& chords) {
    const std::size_t count = chords.points.size(), last = count - 1;
    std::vector<Vec3> tangents(count);
    const auto end_tangent = [&](std::size_t end, std::size_t next) {
        const double share = chords.step(end) / (chords.step(end) + chords.step(next));
        return chords.slope(end) * (1 + share) - chords.slope(next) * share;
    };
    tangents.front() = end_tangent(0, 1);
    tangents.back() = end_tangent(last - 1, last - 2);
    // Thomas' elimination of the tridiagonal system; it is diagonally dominant.
    std::vector<double> above(count, 0.0);
    for (std::size_t i = 1; i < last; ++i) {
        const double before = chords.step(i - 1), after = chords.step(i);
        const Vec3 right = (chords.slope(i - 1) * after + chords.slope(i) * before) * 3.0;
        const double pivot = 2 * (before + after) - after * above[i - 1];
        above[i] = before / pivot;
        tangents[i] = (right - tangents[i - 1] * after) / pivot;
    }
    for (std::size_t i = last; i-- > 1;) tangents[i] -= tangents[i + 1] * above[i];
    return tangents;
}

double distance_from_chord(const Vec3& place, const Vec3& a, const Vec3& b) {
    const Vec3 chord = b - a;
    const double at = std::clamp((place - a).dot(chord) / chord.length2(), 0.0, 1.0);
    return (place - a - chord * at).length();
}

/// Bound of the distance of a span from its chord: the inner control points weigh 3/4 at most.
double departure_of(const ChordLengths& chords, const std::vector<Vec3>& tangents, std::size_t i) {
    const Vec3 &a = chords.points[i], &b = chords.points[i + 1];
    const double third = chords.step(i) / 3;
    return 0.75 * std::max(distance_from_chord(a + tangents[i] * third, a, b),
                           distance_from_chord(b - tangents[i + 1] * third, a, b));
}

/// The control point whose inner knots are those before, at and after point i: the blossom of the
/// span that ends there.
Vec3 inner_control_point(const ChordLengths& chords, const std::vector<Vec3>& tangents,
                         std::size_t i) {
    const double before = chords.step(i - 1), after = chords.step(i);
    const Vec3 bend =
        (tangents[i - 1] * 2.0 + tangents[i] * 4.0 - chords.slope(i - 1) * 6.0) / before;
    return chords.points[i] + tangents[i] * ((after - before) / 3) - bend * (before * after / 6);
}

} // namespace

InterpolatedCurve interpolating_polyline(std::span<const Vec3> points) {
    return polyline(chord_lengths(points));
}

InterpolatedCurve interpolating_spline(std::span<const Vec3> points) {
    const ChordLengths chords = chord_lengths(points);
    const std::size_t count = chords.points.size(), last = count - 1;
    if (count == 2) return polyline(chords);
    const std::vector<Vec3> tangents = spline_tangents(chords);
    InterpolatedCurve spline;
    for (std::size_t i = 0; i < last; ++i)
        spline.departure = std::max(spline.departure, departure_of(chords, tangents, i));
    NurbsCurve<Vec4>& curve = spline.curve;
    curve.degree = 3;
    curve.knots.assign(3, chords.along.front());
    curve.knots.insert(curve.knots.end(), chords.along.begin(), chords.along.end());
    curve.knots.insert(curve.knots.end(), 3, chords.along.back());
    const auto add = [&](const Vec3& point) {
        curve.points.emplace_back(point.x, point.y, point.z, 1);
    };
    add(chords.points.front());
    add(chords.points.front() + tangents.front() * (chords.step(0) / 3));
    for (std::size_t i = 1; i < last; ++i) add(inner_control_point(chords, tangents, i));
    add(chords.points.back() - tangents.back() * (chords.step(last - 1) / 3));
    add(chords.points.back());
    return spline;
}

} // namespace keiko
