#include "keiko/light/tubes/tube_hit.h"

#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {

namespace {

struct ClosedLampRange {
    int begin = 0, end = -1;
};

/// Slightly more than rounding, so that no tube is missed.
constexpr double slack = 1 + 1e-9;

/// Lamps whose endless tubes the ray's line meets. `o` and `d` are in frame coordinates.
ClosedLampRange candidates(const CPlaneFrame& frame, const Vec3& o, const Vec3& d) {
    const double half = std::hypot(d.y, d.z) / std::abs(d.z) * frame.radius() * slack;
    const double v = o.y - o.z / d.z * d.y, last = frame.lamps - 1;
    if (!std::isfinite(half) || !std::isfinite(v)) return {0, frame.lamps - 1};
    const double lowest = std::ceil((v - half - frame.first) / frame.pitch);
    const double highest = std::floor((v + half - frame.first) / frame.pitch);
    return {static_cast<int>(std::clamp(lowest, 0.0, last + 1)),
            static_cast<int>(std::clamp(highest, -1.0, last))};
}

/// The part of the line inside the endless tube around the u-axis at v = 0, or an empty interval.
ParameterInterval in_tube(double radius, const Vec3& o, const Vec3& d) {
    const double a = d.y * d.y + d.z * d.z, b = o.y * d.y + o.z * d.z;
    const double infinity = std::numeric_limits<double>::infinity();
    const double moment = o.y * d.z - o.z * d.y;
    if (!(a > 0)) {
        const bool inside = o.y * o.y + o.z * o.z <= radius * radius;
        return inside ? ParameterInterval{-infinity, infinity} : ParameterInterval{1, 0};
    }
    const double square = a * radius * radius - moment * moment;
    if (!(square >= 0)) return {1, 0};
    const double root = std::sqrt(square);
    return {(-b - root) / a, (-b + root) / a};
}

/// The part of the line between the planes of the caps, or an empty interval.
ParameterInterval between_caps(double length, double o, double d) {
    if (d == 0) {
        const double infinity = std::numeric_limits<double>::infinity();
        const bool inside = o >= 0 && o <= length;
        return inside ? ParameterInterval{-infinity, infinity} : ParameterInterval{1, 0};
    }
    const double a = -o / d, b = (length - o) / d;
    return {std::min(a, b), std::max(a, b)};
}

} // namespace

std::optional<TubeHit> nearest_tube(const CPlaneFrame& frame, const Vec3& origin,
                                    const Vec3& direction) {
    const Vec3 o = frame.point(origin), d = frame.vector(direction);
    const ParameterInterval slab = between_caps(frame.length, o.x, d.x);
    std::optional<TubeHit> nearest;
    const ClosedLampRange range = candidates(frame, o, d);
    for (int lamp = range.begin; lamp <= range.end; ++lamp) {
        const auto tube = in_tube(frame.radius(), o - Vec3(0, frame.axis(lamp), 0), d);
        const double enter = std::max(tube.begin, slab.begin);
        const bool met = enter > 0 && enter <= std::min(tube.end, slab.end);
        if (met && (!nearest || enter < nearest->t))
            nearest = TubeHit{enter, lamp, slab.begin > tube.begin};
    }
    return nearest;
}

double apparent_diameter(const CPlaneFrame& frame, const Vec3& d) {
    return frame.diameter * std::sqrt(d.y * d.y + d.z * d.z) / std::abs(d.z);
}

// Another ray of the bundle is displaced from the centre's by e where that one meets the plane, at
// t. It meets the plane itself at e - (d / d.z) e.z from there, d being its own direction. With e =
// x wx + y wy + rest, the rest counts in full, times 1 + slant. Of wx and wy only their sliding
// along the plane counts, as in the footprint of the centre.
namespace {

/// Far more than the rounding of a look-up.
constexpr double rounding = 1e-9;

/// Half of the sum of one step in x and one in y.
double half_sum(double x, double y) {
    return 0.5 * (std::abs(x) + std::abs(y));
}

/// Image of a bundle on a plane, in frame coordinates.
struct Image {
    double u, v;           ///< mm, of the centre
    double slant;          ///< largest length in mm of a ray for each mm towards the plane
    double footprint;      ///< mm, a bound for each ray's footprint
    double room_u, room_v; ///< mm: largest extent of images and footprints to each side
};

/// Largest half change of a ray over the pixel.
double off(double rest, const Vec3& dx, const Vec3& dy) {
    return rest + half_sum(dx.length(), dy.length());
}

/// Image on a plane that the centre's ray meets at `t`; `least_down`: least component of any
/// direction towards it.
Image image_of(const CPlaneFrame& frame, const RayCone& rays, const Vec3& d, double t,
               double least_down) {
    const RayDifferentials& s = rays.spread;
    const Vec3 wx = frame.vector(s.origin_dx + s.direction_dx * t);
    const Vec3 wy = frame.vector(s.origin_dy + s.direction_dy * t);
    const double direction_off = off(rays.direction_rest, s.direction_dx, s.direction_dy);
    const double slant = (d.length() + direction_off) / least_down;
    const double turn = direction_off * (1 + slant) / least_down; // of d / d.z
    const double rest = rays.origin_rest + t * rays.direction_rest;
    const double later = (rest + half_sum(wx.z, wy.z)) / least_down;
    const double slope_rest = rays.origin_slope_rest + (t + later) * rays.direction_slope_rest +
                              later * std::max(s.direction_dx.length(), s.direction_dy.length());
    // Part of the descent of any ray that remains all over its footprint.
    const double turn_within = half_sum(s.direction_dx.length(), s.direction_dy.length());
    const double left = 1 - (turn_within + rays.direction_slope_rest) / least_down;
    const double widening = left > 0 ? 1 / left : std::numeric_limits<double>::infinity();
    // Twice: the distance of the images, and half a footprint beyond them.
    const auto room = [&](double along_x, double along_y, double along_d) {
        const double slope = along_d / d.z;
        const double images = 2 * (half_sum(along_x - slope * wx.z, along_y - slope * wy.z) +
                                   turn * half_sum(wx.z, wy.z)) +
                              (rest + slope_rest) * (1 + slant);
        return images * widening;
    };
    const Vec3 at = frame.point(rays.origin) + d * t;
    const double room_u = room(wx.x, wy.x, d.x), room_v = room(wx.y, wy.y, d.y);
    const double blur = rounding * (at.length() + t * d.length() + frame.length + frame.last());
    return {at.x,
            at.y,
            slant,
            room_v + blur,
            room_u * (1 + rounding) + blur,
            room_v * (1 + rounding) + blur};
}

/// True if everything within `reach` of v is between lamps or beside all of them. A footprint of
/// many pitches contains the mean of the row.
bool misses_across(const CPlaneFrame& frame, double v, double reach, double footprint) {
    if (footprint > frame.pitch) {
        const double room = reach + frame.pitch / 2;
        return v < frame.first - room || v > frame.last() + room;
    }
    const double nearest = std::floor((v - frame.first) / frame.pitch + 0.5);
    const int lamp = static_cast<int>(std::clamp(nearest, 0.0, frame.lamps - 1.0));
    return std::abs(v - frame.axis(lamp)) > reach;
}

} // namespace

bool misses_lamps(const CPlaneFrame& frame, const RayCone& rays) {
    if (frame.lamps == 0) return true;
    const RayDifferentials& s = rays.spread;
    const double height = frame.normal.dot(rays.origin - frame.origin);
    const Vec3 d = frame.vector(rays.direction);
    const double least_down =
        std::abs(d.z) - off(rays.direction_rest, s.direction_dx, s.direction_dy);
    if (!(least_down > rounding * std::abs(d.z))) return false;
    const double t = -height / d.z;
    if (t < 0)
        return std::abs(height) > (1 + rounding) * off(rays.origin_rest, s.origin_dx, s.origin_dy);
    const Image image = image_of(frame, rays, d, t, least_down);
    // Tubes appear wider by the slant, and their ends bulge by as much.
    const double bulge = (1 + rounding) * frame.radius() * image.slant;
    const double along = image.room_u + bulge, across = image.room_v + bulge;
    if (!(std::isfinite(along) && std::isfinite(across))) return false;
    return image.u < -along || image.u > frame.length + along ||
           misses_across(frame, image.v, across, image.footprint);
}

LampRange lamps_in_cone(const CPlaneFrame& frame, const Vec3& point, const Vec3& axis,
                        double half_angle) {
    const LampRange all{0, frame.lamps};
    // Tubes rise from the plane by their radius: a wider cone than at the plane.
    const Vec3 at = frame.point(point), r = frame.vector(axis);
    const double height = std::abs(at.z) + frame.radius();
    const double towards = at.z > 0 ? -r.z : r.z;
    if (!(half_angle < std::numbers::pi / 2) || !(towards > 0)) return all;
    const double c = std::cos(half_angle), k = r.x * r.x + r.y * r.y - c * c;
    const double square =
        towards * towards * r.y * r.y - k * (towards * towards + r.x * r.x - c * c);
    if (!(k < 0) || !(square >= 0)) return all;
    const double a = (-towards * r.y + std::sqrt(square)) / k;
    const double b = (-towards * r.y - std::sqrt(square)) / k;
    const double margin = frame.radius() * (1 + std::hypot(a, b));
    const double low = at.y + height * std::min(a, b) - margin;
    const double high = at.y + height * std::max(a, b) + margin;
    const double first = std::ceil((low - frame.first) / frame.pitch);
    const double last = std::floor((high - frame.first) / frame.pitch);
    return {static_cast<int>(std::clamp(first, 0.0, frame.lamps * 1.0)),
            static_cast<int>(std::clamp(last + 1, 0.0, frame.lamps * 1.0))};
}

} // namespace keiko
