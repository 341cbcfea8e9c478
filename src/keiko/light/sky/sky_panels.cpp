#include "keiko/light/sky/sky_panels.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/elevations.h"
#include "keiko/math/convex_clip.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Distance of the sky, mm: far enough that nothing in a scene lies beyond, as of the sun.
constexpr double far_away = 1e7;
constexpr int quarters = 4;
/// Height of a quarter's top corner above or below the point, as a share of its distance to the
/// middle of the horizon's side.
constexpr double apex = 0.7;
/// Least distance from a window's plane that counts, as a share of the window's size: closer to it,
/// bodies outside are viewed to that distance only.
constexpr double closest = 1e-3;
/// Error of a clear sky's light along a line.
constexpr double along_line = 1e-7;

/// A quarter of the sphere above or below the horizon, around azimuth `number` x 90 degrees: both
/// corners of the horizon's side, then the top.
std::vector<Vec3> quarter(int number, bool ground) {
    constexpr std::array<Vec2, quarters> ways{Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)};
    const Vec2& middle = ways[static_cast<std::size_t>(number)];
    const Vec2 left(-middle.y, middle.x);
    const Vec2 a = middle - left, b = middle + left;
    return {Vec3(a.x, a.y, 0), Vec3(b.x, b.y, 0), Vec3(0, 0, ground ? -apex : apex)};
}

/// The part of a window on one side of the horizon of a point, relative to it.
std::vector<Vec3> above_level(const Window& window, const Vec3& point, bool ground) {
    std::vector<Vec3> part;
    clip_convex(
        window.corners,
        [&](std::size_t i) { return (window.corners[i].z - point.z) * (ground ? -1 : 1); },
        [&](const Vec3& corner) { part.push_back(corner - point); });
    return part;
}

/// Factor that takes a window, given by corners relative to the point, far away.
double enlargement(std::span<const Vec3> corners) {
    const Vec3 normal = polygon_normal(corners);
    const double size = std::sqrt(normal.length());
    const double distance = std::abs(normal.normalized().dot(corners.front()));
    return far_away / std::max(distance, closest * size);
}

} // namespace

int panel_count(const SkyLight& sky) {
    const int parts = sky.windows.empty() ? quarters : static_cast<int>(sky.windows.size());
    return sky.ground == Rgb(0) ? parts : 2 * parts;
}

std::optional<SkyPanel> sky_panel(const SkyLight& sky, int number, const Vec3& point) {
    const int parts = sky.windows.empty() ? quarters : static_cast<int>(sky.windows.size());
    SkyPanel panel{{{}, Rgb(1), true}, number >= parts, {}, {}, {}};
    const int part = number % parts;
    std::vector<Vec3> corners;
    double factor = far_away;
    if (sky.windows.empty()) {
        corners = quarter(part, panel.ground);
    } else {
        corners = above_level(sky.windows[static_cast<std::size_t>(part)], point, panel.ground);
        if (corners.size() < 3 || !(polygon_normal(corners).length() > 0)) return std::nullopt;
        factor = enlargement(corners);
        panel.window = 1 / factor;
        panel.others = std::span(sky.windows).first(static_cast<std::size_t>(part));
    }
    for (const Vec3& corner : corners) panel.outline.corners.push_back(point + corner * factor);
    panel.along = sky.windows.empty() ? corners[2] - (corners[0] + corners[1]) / 2
                                      : longest_side(panel.outline);
    return panel;
}

std::optional<SkyWidth> SkyWidth::of(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                                     const Vec3& normal) {
    const auto lines = PolygonWidth::of(panel.outline, panel.along, point, normal);
    if (!lines) return std::nullopt;
    return SkyWidth(sky, panel, *lines, point, normal);
}

std::vector<double> SkyWidth::cuts() const {
    std::vector<double> places = lines_.cuts();
    if (!around_sun()) return places;
    const double sun = lines_.place_in(shares_.sun());
    if (sun > -1 && sun < 1)
        places.insert(std::upper_bound(places.begin(), places.end(), sun), sun);
    return places;
}

double SkyWidth::lit(const SubAxis& axis, double begin, double end) const {
    if (ground_ || (shares_.is_linear() && shares_.rise() == 0))
        return (ground_ ? 1 : shares_.level()) * lines_.lit(axis, begin, end);
    const Segment line = lines_.line_of(axis);
    const Vec3 level = direction(axis, 0), along = direction(axis, 1);
    const auto elevation = [&](double t) {
        const Vec3 way = line.at(t) - point_;
        return half_tangent(way.dot(along), way.dot(level));
    };
    const ParameterInterval seen{elevation(begin), elevation(end)};
    double sum = 0;
    for (const ParameterInterval& all : lines_.elevations(axis)) {
        // A line ends just inside the source, which it stands for as a whole.
        const ParameterInterval part{begin > 0 ? std::max(all.begin, seen.begin) : all.begin,
                                     end < 1 ? std::min(all.end, seen.end) : all.end};
        if (part.begin < part.end)
            sum += shares_.is_linear() ? lit_linearly(axis, part) : lit_by_rule(axis, part);
    }
    return sum;
}

double SkyWidth::brightest() const {
    if (ground_) return 1;
    if (shares_.is_linear()) return std::max(shares_.level(), 1.0);
    // The indicatrix is largest at the sun; the gradation is 1 at most, and least at the zenith.
    const double least_gradation = -std::expm1(-0.32);
    return shares_(shares_.sun()) / least_gradation;
}

/// Integral of (N.w) cos eta (level + rise w.z): of sums of products of sines and cosines.
double SkyWidth::lit_linearly(const SubAxis& axis, const ParameterInterval& elevations) const {
    const Vec3 level = direction(axis, 0), along = direction(axis, 1);
    const double nl = normal_.dot(level), na = normal_.dot(along);
    const auto cubic = [&](double t) {
        const double q = 1 / (1 + t * t), s = 2 * t * q, c = (1 - t * t) * q;
        return nl * level.z * (s - s * s * s / 3) - (nl * along.z + na * level.z) * c * c * c / 3 +
               na * along.z * s * s * s / 3;
    };
    return shares_.level() * arc_integral(nl, na, elevations) +
           shares_.rise() * (cubic(elevations.end) - cubic(elevations.begin));
}

double SkyWidth::lit_by_rule(const SubAxis& axis, const ParameterInterval& elevations) const {
    const Vec3 level = direction(axis, 0), along = direction(axis, 1);
    Breakpoints range(elevations.begin, elevations.end);
    range.cut_at(std::tan(std::atan2(shares_.sun().dot(along), shares_.sun().dot(level)) / 2));
    return integrate_paired([&](double t) { return light_rate(axis, t); }, range, along_line);
}

} // namespace keiko
