#include "keiko/tubes/c_plane_lookup.h"

#include "keiko/tubes/end_coverage.h"
#include "keiko/tubes/stripe_coverage.h"
#include "keiko/tubes/tube_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {
namespace {

/// Sine of the angle to the plane below which a ray counts as parallel (physics 3.2).
constexpr double parallel = 1e-12;

/// Stripes are given up, and their mean shown, where a pixel spans more pitches.
constexpr double resolvable_pitches = 4;

/// Derivative of (u, v) by one picture axis: the hit moves with the ray and stays on the plane.
Vec2 slide(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin_rate,
           const Vec3& direction_rate) {
    const Vec3& d = hit.direction;
    const Vec3 rate = frame.vector(origin_rate + direction_rate * hit.t);
    const double t_rate = rate.z / d.z;
    return {rate.x - d.x * t_rate, rate.y - d.y * t_rate};
}

/// How far along u the ray runs from a tube's surface to the level of its axis, mm: the mean over
/// the tube's width, pi / 4 of that over its middle. `d`: its direction, in frame coordinates.
double rim_shift(const CPlaneFrame& frame, const Vec3& d) {
    return std::numbers::pi / 4 * frame.radius() * d.x / std::sqrt(d.y * d.y + d.z * d.z);
}

bool tube_shines(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction) {
    const auto tube = nearest_tube(frame, origin, direction);
    return tube && (!tube->cap || frame.luminous_caps);
}

bool point_shines(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin,
                  const Vec3& direction, TubeLook look) {
    if (look == TubeLook::flat) return strip_at(frame, hit.u, hit.v, frame.diameter).has_value();
    return tube_shines(frame, origin, direction);
}

/// The ends of the lamps as they look on the plane, mm along u: the near ends of dark-capped tubes
/// hide behind their rims, luminous caps add to both.
LampEnds ends_of(const CPlaneFrame& frame, const CPlaneHit& hit, bool round) {
    if (!round) return {0, frame.length};
    const double shift = rim_shift(frame, hit.direction);
    if (frame.luminous_caps) return {-std::abs(shift), frame.length + std::abs(shift)};
    return {shift, frame.length + shift};
}

/// The lamps that lie ahead of a ray that starts between the planes that touch all tubes: of those
/// behind it the line may run through the strips as well.
CPlaneFrame ahead(CPlaneFrame frame, const CPlaneHit& hit) {
    const Vec3& d = hit.direction;
    if (d.y == 0 || frame.lamps == 0) return frame;
    const double nearest = hit.v - hit.t * (d.y * d.y + d.z * d.z) / d.y;
    const double place =
        std::clamp((nearest - frame.first) / frame.pitch, -1.0, double(frame.lamps));
    const int behind = static_cast<int>(std::floor(place)) + 1; // lamps of lesser v
    if (d.y > 0) frame.first = frame.axis(std::min(behind, frame.lamps));
    frame.lamps = std::max(d.y > 0 ? frame.lamps - behind : std::min(behind, frame.lamps), 0);
    return frame;
}

/// The mean over a grid of parallel rays through the footprint.
StripeLook sampled(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction,
                   const Footprint& footprint) {
    constexpr int side = 16;
    int lit = 0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const Vec2 offset =
                footprint.dx * ((i + 0.5) / side - 0.5) + footprint.dy * ((j + 0.5) / side - 0.5);
            const Vec3 from = origin + frame.u * offset.x + frame.v * offset.y;
            lit += tube_shines(frame, from, direction) ? 1 : 0;
        }
    return {lit / static_cast<double>(side * side), true};
}

StripeLook filtered(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& direction,
                    const Footprint& footprint, TubeLook look) {
    const bool round = look == TubeLook::tube;
    const PixelFilter across(footprint.dx.y, footprint.dy.y);
    const bool resolved = across.width() <= resolvable_pitches * frame.pitch;
    const LampEnds ends = ends_of(frame, hit, round);
    const double reach = footprint.reach(0);
    if (frame.lamps == 0 || hit.u + reach <= ends.begin || hit.u - reach >= ends.end)
        return {0, resolved};
    const double width = round ? apparent_diameter(frame, direction) : frame.diameter;
    if (!(hit.u - reach >= ends.begin && hit.u + reach <= ends.end))
        return {end_coverage(frame, width, resolved, ends, {hit.u, hit.v}, footprint), resolved};
    const auto coverage = resolved ? comb_coverage : mean_coverage;
    return {coverage(frame, width, hit.v, across), resolved};
}

} // namespace

double Footprint::reach(unsigned axis) const {
    const double least = 1 - (std::abs(descent.x) + std::abs(descent.y)) / 2;
    if (!(least > 0)) return std::numeric_limits<double>::infinity();
    return (std::abs(dx[axis]) + std::abs(dy[axis])) / (2 * least);
}

std::optional<CPlaneHit> c_plane_coordinates(const CPlaneFrame& frame, const Vec3& origin,
                                             const Vec3& direction) {
    const Vec3 o = frame.point(origin), d = frame.vector(direction);
    if (!(std::abs(d.z) > parallel * direction.length())) return {};
    const double t = -o.z / d.z;
    if (!(t > 0)) return {};
    return CPlaneHit{t, o.x + t * d.x, o.y + t * d.y, d};
}

std::optional<CPlaneHit> c_plane_coordinates(const CPlane& plane, const Vec3& origin,
                                             const Vec3& direction) {
    return c_plane_coordinates(CPlaneFrame(plane), origin, direction);
}

bool starts_among_tubes(const CPlaneFrame& frame, const CPlaneHit& hit) {
    return hit.t * std::abs(hit.direction.z) < frame.radius();
}

Footprint footprint_on(const CPlaneFrame& frame, const CPlaneHit& hit,
                       const RayDifferentials& spread) {
    return {slide(frame, hit, spread.origin_dx, spread.direction_dx),
            slide(frame, hit, spread.origin_dy, spread.direction_dy),
            Vec2(frame.normal.dot(spread.direction_dx), frame.normal.dot(spread.direction_dy)) /
                hit.direction.z};
}

std::optional<int> strip_at(const CPlaneFrame& frame, double u, double v, double width) {
    if (frame.lamps == 0 || !(u > 0 && u < frame.length)) return {};
    const double nearest = std::floor((v - frame.first) / frame.pitch + 0.5);
    const int lamp = static_cast<int>(std::clamp(nearest, 0.0, frame.lamps - 1.0));
    if (!(std::abs(v - frame.axis(lamp)) < width / 2)) return {};
    return lamp;
}

StripeLook look_up(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction,
                   const Footprint& footprint, TubeLook look) {
    const auto hit = c_plane_coordinates(frame, origin, direction);
    return hit ? look_up(frame, *hit, origin, direction, footprint, look) : StripeLook();
}

StripeLook look_up(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin,
                   const Vec3& direction, const Footprint& footprint, TubeLook look) {
    if (footprint.is_point())
        return {point_shines(frame, hit, origin, direction, look) ? 1.0 : 0.0, true};
    if (look == TubeLook::exact) return sampled(frame, origin, direction, footprint);
    if (look == TubeLook::tube && starts_among_tubes(frame, hit))
        return filtered(ahead(frame, hit), hit, direction, footprint, look);
    return filtered(frame, hit, direction, footprint, look);
}

Rgb mirrored_luminance(const CPlane& plane, const Vec3& origin, const Vec3& direction,
                       const Footprint& footprint, TubeLook look) {
    return plane.luminance *
           look_up(CPlaneFrame(plane), origin, direction, footprint, look).coverage;
}

} // namespace keiko
