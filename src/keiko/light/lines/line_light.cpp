#include "keiko/light/lines/line_light.h"

#include "keiko/light/luminance/flush.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/luminance/projected_solid_angle.h"

#include <algorithm>

namespace keiko {
namespace {

/// Distance from a line, as a share of that to its farther end, that is rounding.
constexpr double rounding = 1e-9;

LinePiece piece_of(const LineView& view, const ParameterInterval& part, const Vec3& normal) {
    return {view.x_at(part.begin), view.x_at(part.end), view.distance, normal.dot(view.along),
            normal.dot(view.across)};
}

} // namespace

ParameterInterval LineView::above_horizon(const ParameterInterval& part, const Vec3& normal) const {
    const LinePiece above = keiko::above_horizon(piece_of(*this, part, normal));
    return elevations({(above.begin - begin) / length, (above.end - begin) / length});
}

std::optional<LineView> view_of(const LineLight& light, const Vec3& point) {
    const Vec3 way = light.b - light.a, to_a = light.a - point;
    LineView view;
    view.point = point;
    view.length = way.length();
    view.along = way / view.length;
    view.begin = view.along.dot(to_a);
    const Vec3 foot = to_a - view.along * view.begin;
    view.distance = foot.length();
    const double farthest = std::max(std::abs(view.begin), std::abs(view.x_at(1)));
    if (!(view.distance > rounding * farthest)) return std::nullopt;
    view.across = foot / view.distance;
    return view;
}

double unit_illuminance(const LineView& view, const Vec3& normal, const IntervalSet& visible) {
    double per_millimetre = 0;
    for (const ParameterInterval& part : visible) {
        const LinePiece above = above_horizon(piece_of(view, part, normal));
        if (above.begin < above.end) per_millimetre += cosine_line_integral(above);
    }
    return per_metre(per_millimetre);
}

Segment queried_line(const LineLight& light, const Vec3& point) {
    const auto before = [&](const Vec3& end) { return end + (point - end) * flush; };
    return {before(light.a), before(light.b)};
}

bool holds(const LineLight& light, const Vec3& point) {
    const Vec3 way = light.b - light.a;
    const double t = std::clamp((point - light.a).dot(way) / way.length2(), 0.0, 1.0);
    return (light.a + way * t - point).length() <= rounding * way.length();
}

} // namespace keiko
