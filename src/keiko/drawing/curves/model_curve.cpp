#include "keiko/drawing/curves/model_curve.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::string_view name_of(CurveKind kind) {
    constexpr std::array<std::string_view, curve_kinds> names{
        "outlines", "edges", "creases", "seams", "iso-curves", "sections", "lines"};
    return names[static_cast<std::size_t>(kind)];
}

namespace {

/// The chord of a course that holds a parameter, and the share of the way along it.
struct ChordPlace {
    std::size_t index;
    double share;

    ChordPlace(double t, const CurveCourse& course) {
        const double begin = std::clamp(std::floor(t), 0.0, course.end() - 1);
        index = static_cast<std::size_t>(begin);
        share = std::clamp(t - begin, 0.0, 1.0);
    }
};

} // namespace

Vec3 CurveCourse::at(double t) const {
    const ChordPlace place(t, *this);
    const Vec3 &a = points[place.index], &b = points[place.index + 1];
    if (place.share == 0) return a;
    if (place.share == 1) return b;
    return between ? between(place.index, place.share) : a + (b - a) * place.share;
}

Vec3 CurveCourse::derivative(double t) const {
    constexpr double step = 1e-4; // its error in second order is that of rounding at this size
    const double begin = std::clamp(std::floor(t), 0.0, end() - 1);
    const double low = std::max(t - step, begin), high = std::min(t + step, begin + 1);
    return (at(high) - at(low)) / (high - low);
}

double CurveCourse::length() const {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).length();
    return length;
}

bool ModelCurve::is_contour_edge(double t, const ImageProjection& projection) const {
    if (!sides) return false;
    const ChordPlace on(t, course);
    const Vec3 place = course.at(t);
    const Vec2 run = projection.image_direction(place, course.derivative(t));
    // Sine below which a face is seen edge-on, so that the other one ends alone.
    constexpr double edge_on = 1e-6;
    const auto side = [&](const Vec3& inward) {
        const Vec2 image = projection.image_direction(place, inward);
        const double across = run.cross(image);
        return std::abs(across) > edge_on * run.length() * inward.length() ? across : 0;
    };
    const auto [a, b] = sides(on.index, on.share);
    return side(a) * side(b) >= 0;
}

Vec3 OccludingCurve::inward_at(double t) const {
    const ChordPlace place(t, course);
    return inward(place.index, place.share);
}

} // namespace keiko
