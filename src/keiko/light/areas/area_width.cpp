#include "keiko/light/areas/area_width.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/elevations.h"
#include "keiko/light/luminance/flush.h"
#include "keiko/math/convex_clip.h"
#include "keiko/math/polygon.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Angle, rad, under which a plane must be viewed for its light to be more than rounding.
constexpr double edge_on = 1e-9;
/// Share of a width that the outermost lines lie within it, as a line along a side has no length.
constexpr double inside = 1e-9;

} // namespace

AreaWidth::AreaWidth(const Vec3& through, const Vec3& plane_normal, const Vec3& along,
                     const Vec3& point, const Vec3& normal)
    : point_(point),
      ahead_(-plane_normal),
      along_(along),
      across_(along.cross(plane_normal)),
      distance_(plane_normal.dot(point - through)),
      foot_(point + ahead_ * distance_),
      n_ahead_(normal.dot(ahead_)),
      n_along_(normal.dot(along_)),
      n_across_(normal.dot(across_)) {}

SubAxis AreaWidth::line_at(double v, double weight) const {
    const double r = std::hypot(distance_, v);
    return {distance_ / r, v / r, r, weight};
}

double AreaWidth::wedge_angle(const Vec3& way) const {
    return std::atan2(way.dot(across_), way.dot(ahead_));
}

Segment AreaWidth::line_of(const SubAxis& axis) const {
    // In front of the source, as a surface that the source is flush with hides nothing of it.
    const Vec3 start =
        point_ + ahead_ * distance_ * (1 - flush) + across_ * (axis.r * axis.sine * (1 - flush));
    const Vec3 along = along_ * (1 - flush);
    return {start + along * extent_.begin, start + along * extent_.end};
}

double AreaWidth::level(const SubAxis& axis) const {
    return n_ahead_ * axis.cosine + n_across_ * axis.sine;
}

double AreaWidth::lit(const SubAxis& axis, double begin, double end) const {
    double sum = 0;
    for (const ParameterInterval& part : elevations(axis, begin, end))
        sum += arc_integral(level(axis), n_along_, part);
    return sum;
}

std::vector<ParameterInterval> AreaWidth::elevations(const SubAxis& axis, double begin,
                                                     double end) const {
    const double from = extent_.begin + begin * extent_.length();
    const double to = extent_.begin + end * extent_.length();
    std::vector<ParameterInterval> all;
    for (const ParameterInterval& chord : chords(axis.r * axis.sine)) {
        const ParameterInterval part{std::max(chord.begin, from), std::min(chord.end, to)};
        if (!(part.begin < part.end)) continue;
        const ParameterInterval above =
            above_horizon(level(axis), n_along_,
                          {half_tangent(part.begin, axis.r), half_tangent(part.end, axis.r)});
        if (above.begin < above.end) all.push_back(above);
    }
    return all;
}

double AreaWidth::light_rate(const SubAxis& axis, double half_tangent) const {
    const double t = half_tangent, q = 1 / (1 + t * t), cosine = (1 - t * t) * q;
    return (level(axis) * cosine + n_along_ * 2 * t * q) * cosine * 2 * q;
}

Vec3 AreaWidth::direction(const SubAxis& axis, double half_tangent) const {
    const double q = 1 / (1 + half_tangent * half_tangent);
    const Vec3 level = ahead_ * axis.cosine + across_ * axis.sine;
    return level * ((1 - half_tangent * half_tangent) * q) + along_ * (2 * half_tangent * q);
}

std::optional<PolygonWidth> PolygonWidth::of(const PolygonLight& light, const Vec3& point,
                                             const Vec3& normal) {
    return of(light, longest_side(light), point, normal);
}

std::optional<PolygonWidth> PolygonWidth::of(const PolygonLight& light, const Vec3& direction,
                                             const Vec3& point, const Vec3& normal) {
    if (!light.shines_at(point)) return std::nullopt;
    Vec3 facing = light.normal();
    if (facing.dot(point - light.corners[0]) < 0) facing = -facing;
    const Vec3 along = (direction - facing * facing.dot(direction)).normalized();
    PolygonWidth width(light, facing, along, point, normal);
    const double away = edge_on * (point - light.corners[0]).length();
    const bool grazed = width.corners_.size() < 3 || !(width.half_ > 0) ||
                        !(width.extent().length() > edge_on * width.distance());
    if (!(width.distance() > away) || grazed) return std::nullopt;
    return width;
}

PolygonWidth::PolygonWidth(const PolygonLight& light, const Vec3& plane_normal, const Vec3& along,
                           const Vec3& point, const Vec3& normal)
    : AreaWidth(light.corners[0], plane_normal, along, point, normal) {
    std::vector<Vec2> all;
    for (const Vec3& corner : light.corners) all.push_back(place_of(corner));
    clip_convex(
        all, [&](std::size_t i) { return elevation(all[i]); },
        [&](const Vec2& corner) { corners_.push_back(corner); });
    if (corners_.empty()) return;
    const auto [left, right] = std::minmax_element(
        corners_.begin(), corners_.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    const auto [low, high] = std::minmax_element(
        corners_.begin(), corners_.end(), [](const Vec2& a, const Vec2& b) { return a.y < b.y; });
    set_extent({left->x, right->x});
    const double from = std::atan2(low->y, distance()), to = std::atan2(high->y, distance());
    middle_ = (from + to) / 2;
    half_ = (to - from) / 2 * (1 - inside);
}

SubAxis PolygonWidth::sub_axis(double place) const {
    return line_at(distance() * std::tan(middle_ + half_ * place), half_);
}

std::vector<double> PolygonWidth::cuts() const {
    constexpr double apart = 1e-6; // of places, below which no line lies between
    std::vector<double> places{-1, 1};
    for (const Vec2& corner : corners_) {
        const double place = (std::atan2(corner.y, distance()) - middle_) / half_;
        if (std::abs(place) < 1 - apart) places.push_back(place);
    }
    std::sort(places.begin(), places.end());
    const auto near = [](double a, double b) { return b - a < apart; };
    places.erase(std::unique(places.begin(), places.end(), near), places.end());
    return places;
}

double PolygonWidth::place_in(const Vec3& way) const {
    return (wedge_angle(way) - middle_) / half_;
}

/// By the even-odd rule. Sides that clipping doubled cancel.
std::vector<ParameterInterval> PolygonWidth::chords(double v) const {
    std::vector<double> crossings;
    each_crossing(corners_, v, [&](double u) { crossings.push_back(u); });
    std::sort(crossings.begin(), crossings.end());
    std::vector<ParameterInterval> chords;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        chords.push_back({crossings[i], crossings[i + 1]});
    return chords;
}

} // namespace keiko
