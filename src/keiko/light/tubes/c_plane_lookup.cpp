#include "keiko/light/tubes/c_plane_lookup.h"

#include "keiko/light/tubes/end_coverage.h"
#include "keiko/light/tubes/stripe_coverage.h"
#include "keiko/light/tubes/tube_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

bool tube_shines(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction) {
    const auto tube = nearest_tube(frame, origin, direction);
    return tube && (!tube->cap || frame.luminous_caps);
}

bool point_shines(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin,
                  const Vec3& direction, MirrorModel look) {
    if (look == MirrorModel::flat) return strip_at(frame, hit.u, hit.v, frame.diameter).has_value();
    return tube_shines(frame, origin, direction);
}

/// The lamps ahead of a ray that starts between the planes that touch all tubes. The ray's line may
/// run through the strips of lamps behind it as well.
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

/// The direction, in frame coordinates, of the pixel's ray that meets the plane at an offset of
/// `way` from the centre's hit, or of the pixel's ray nearest to that. Near the plane's horizon
/// rays have another slant.
Vec3 direction_to(const CPlaneHit& hit, const Footprint& footprint, const Vec2& way) {
    if (way == Vec2(0)) return hit.direction;
    // The denominator of (x dx + y dy) / (1 + x descent.x + y descent.y) = way.
    const Vec2 dx = footprint.dx - way * footprint.descent.x;
    const Vec2 dy = footprint.dy - way * footprint.descent.y;
    const double descent = footprint.dx.cross(footprint.dy) / dx.cross(dy);
    const double off = (std::abs(footprint.descent.x) + std::abs(footprint.descent.y)) / 2;
    const double seen = descent > 0 ? std::clamp(descent, 1 - off, 1 + off) : 1 + off;
    return {hit.direction.x, hit.direction.y, hit.direction.z * seen};
}

/// Offset from the hit to the nearest point of the row.
Vec2 way_to_row(const CPlaneFrame& frame, const CPlaneHit& hit) {
    return {std::clamp(hit.u, 0.0, frame.length) - hit.u,
            std::clamp(hit.v, frame.first, frame.last()) - hit.v};
}

/// The ends of all lamps, each from one direction: that to the end of the lamp whose axis is
/// nearest to the hit.
LampEnds ends_of_tubes(const CPlaneFrame& frame, const CPlaneHit& hit, const Footprint& footprint,
                       const Vec3& direction) {
    const LampEnds guess = LampEnds::of_tubes(frame, direction);
    const double lamp =
        std::clamp(std::round((hit.v - frame.first) / frame.pitch), 0.0, frame.lamps - 1.0);
    const double half = apparent_diameter(frame, direction) / 2;
    const double axis = frame.first + lamp * frame.pitch;
    const double q = std::clamp((hit.v - axis) / half, -1.0, 1.0);
    const auto seen = [&](const LampEnd& end) {
        const double u = end.at + end.shear * q + end.bulge * std::sqrt(1 - q * q);
        const Vec2 way(u - hit.u, way_to_row(frame, hit).y);
        return LampEnds::of_tubes(frame, direction_to(hit, footprint, way));
    };
    return {seen(guess.begin).begin, seen(guess.end).end};
}

/// The mean over a grid of parallel rays through the footprint.
LampCoverage sampled(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction,
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

LampCoverage filtered(const CPlaneFrame& frame, const CPlaneHit& hit, const Footprint& footprint,
                      MirrorModel look) {
    const StripeCoverage<double> stripes(frame, look, true, hit, footprint);
    if (!stripes.at_ends) return {stripes.coverage, stripes.resolved};
    const bool round = look == MirrorModel::tube;
    const Vec3 d = round ? direction_to(hit, footprint, way_to_row(frame, hit)) : hit.direction;
    const LampEnds ends =
        round ? ends_of_tubes(frame, hit, footprint, d) : LampEnds::straight(frame);
    const double width = round ? apparent_diameter(frame, d) : frame.diameter;
    return {end_coverage(frame, width, stripes.resolved, ends, {hit.u, hit.v}, footprint),
            stripes.resolved};
}

} // namespace

std::optional<CPlaneHit> c_plane_coordinates(const CPlaneFrame& frame, const Vec3& origin,
                                             const Vec3& direction) {
    const CPlaneHit hit = c_plane_hit(frame, origin, direction);
    if (!is_met(hit)) return {};
    return hit;
}

std::optional<CPlaneHit> c_plane_coordinates(const CPlane& plane, const Vec3& origin,
                                             const Vec3& direction) {
    return c_plane_coordinates(CPlaneFrame(plane), origin, direction);
}

std::optional<int> strip_at(const CPlaneFrame& frame, double u, double v, double width) {
    if (frame.lamps == 0 || !(u > 0 && u < frame.length)) return {};
    const int lamp = static_cast<int>(nearest_lamp(frame, v));
    if (!(std::abs(v - frame.axis(lamp)) < width / 2)) return {};
    return lamp;
}

LampCoverage look_up(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction,
                     const Footprint& footprint, MirrorModel look) {
    const auto hit = c_plane_coordinates(frame, origin, direction);
    return hit ? look_up(frame, *hit, origin, direction, footprint, look) : LampCoverage();
}

LampCoverage look_up(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin,
                     const Vec3& direction, const Footprint& footprint, MirrorModel look) {
    if (footprint.is_point())
        return {point_shines(frame, hit, origin, direction, look) ? 1.0 : 0.0, true};
    if (look == MirrorModel::exact) return sampled(frame, origin, direction, footprint);
    if (look == MirrorModel::tube && starts_among_tubes(frame, hit))
        return filtered(ahead(frame, hit), hit, footprint, look);
    return filtered(frame, hit, footprint, look);
}

Rgb mirrored_luminance(const CPlane& plane, const Vec3& origin, const Vec3& direction,
                       const Footprint& footprint, MirrorModel look) {
    return plane.luminance *
           look_up(CPlaneFrame(plane), origin, direction, footprint, look).coverage;
}

} // namespace keiko
