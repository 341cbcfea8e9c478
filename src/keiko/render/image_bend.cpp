#include "keiko/render/image_bend.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// What of a ray, or of a derivative of one, tells where it meets a plane across the lamps: the
/// components along the plane's v and its normal of origin and direction.
struct Across {
    double origin_v, origin_height, direction_v, direction_height;

    Across operator+(const Across& o) const {
        return {origin_v + o.origin_v, origin_height + o.origin_height, direction_v + o.direction_v,
                direction_height + o.direction_height};
    }
    Across operator-(const Across& o) const {
        return {origin_v - o.origin_v, origin_height - o.origin_height, direction_v - o.direction_v,
                direction_height - o.direction_height};
    }
    Across operator*(double s) const {
        return {origin_v * s, origin_height * s, direction_v * s, direction_height * s};
    }
};

Across across(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction) {
    return {frame.v.dot(origin), frame.normal.dot(origin), frame.v.dot(direction),
            frame.normal.dot(direction)};
}

Slopes<Across> slopes_of(const CPlaneFrame& frame, const Ray& ray) {
    const RayDifferentials& d = *ray.differentials;
    return {across(frame, d.origin_dx, d.direction_dx), across(frame, d.origin_dy, d.direction_dy)};
}

/// How fast the place across the lamps moves of a ray that meets the plane at t.
double slide(const Across& ray, const Across& slope, double t) {
    const double v = slope.origin_v + t * slope.direction_v;
    const double height = slope.origin_height + t * slope.direction_height;
    return v - ray.direction_v * height / ray.direction_height;
}

} // namespace

std::optional<double> image_bend(const RigPlaneHit& plane, const PixelRays& rays) {
    const CPlaneFrame& frame = *plane.frame;
    const Across centre = across(frame, rays.centre.origin - frame.origin, rays.centre.direction);
    const Slopes<Across> slopes = slopes_of(frame, rays.centre);
    const PixelCubic<Across> cubic(centre, slopes, slopes_of(frame, rays.left),
                                   slopes_of(frame, rays.right), slopes_of(frame, rays.above),
                                   slopes_of(frame, rays.below));
    const double by_x = slide(centre, slopes.x, plane.at.t);
    const double by_y = slide(centre, slopes.y, plane.at.t);
    double off = 0;
    const std::array<double, 4> told{-by_x - by_y, by_x - by_y, by_y - by_x, by_x + by_y};
    const std::array<Across, 4> corners = cubic.corners();
    for (std::size_t i = 0; i < 4; ++i) {
        const Across& corner = corners[i];
        const double t = -corner.origin_height / corner.direction_height;
        if (!(t > 0 && std::isfinite(t))) return {};
        const double v = corner.origin_v + t * corner.direction_v;
        off = std::max(off, std::abs(v - plane.at.v - told[i] / 2));
    }
    return off / frame.pitch;
}

} // namespace keiko
