#include "keiko/render/reflection/footprint_nonlinearity.h"

#include "keiko/light/tubes/lamp_ends.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// What of a ray, or of a derivative of one, tells where it meets a plane along one of its axes:
/// the components along that axis and the plane's normal of origin and direction.
struct Slice {
    double origin, origin_height, direction, direction_height;

    Slice operator+(const Slice& o) const {
        return {origin + o.origin, origin_height + o.origin_height, direction + o.direction,
                direction_height + o.direction_height};
    }
    Slice operator-(const Slice& o) const {
        return {origin - o.origin, origin_height - o.origin_height, direction - o.direction,
                direction_height - o.direction_height};
    }
    Slice operator*(double s) const {
        return {origin * s, origin_height * s, direction * s, direction_height * s};
    }
};

/// Pixels' rays along an axis of a plane, 0 along the lamps, 1 across.
class Slicing {
public:
    Slicing(const CPlaneFrame& frame, unsigned axis)
        : frame_(frame), axis_(axis == 0 ? frame.u : frame.v) {}

    CubicFootprint<Slice> cubic(const PixelRays& rays) const {
        return {of(rays.centre.origin - frame_.origin, rays.centre.direction),
                slopes(rays.centre),
                slopes(rays.left),
                slopes(rays.right),
                slopes(rays.above),
                slopes(rays.below)};
    }

private:
    Slice of(const Vec3& origin, const Vec3& direction) const {
        return {axis_.dot(origin), frame_.normal.dot(origin), axis_.dot(direction),
                frame_.normal.dot(direction)};
    }
    Slopes<Slice> slopes(const Ray& ray) const {
        const RayDifferentials& d = *ray.differentials;
        return {of(d.origin_dx, d.direction_dx), of(d.origin_dy, d.direction_dy)};
    }

    const CPlaneFrame& frame_;
    const Vec3& axis_;
};

/// Where the rays of a pixel's corners meet a plane along an axis, mm, row by row; nothing where
/// one does not.
std::optional<std::array<double, 4>> corners_of(const CPlaneFrame& frame, unsigned axis,
                                                const PixelRays& rays) {
    std::array<double, 4> places{};
    const std::array<Slice, 4> corners = Slicing(frame, axis).cubic(rays).corners();
    for (std::size_t i = 0; i < 4; ++i) {
        const double t = -corners[i].origin_height / corners[i].direction_height;
        if (!(t > 0 && std::isfinite(t))) return {};
        places[i] = corners[i].origin + t * corners[i].direction;
    }
    return places;
}

/// What a linear function is at the corners of a pixel at whose centre it is 0.
std::array<double, 4> linear_corners(double by_x, double by_y) {
    const double sum = (by_x + by_y) / 2, rise = (by_x - by_y) / 2;
    return {-sum, rise, -rise, sum};
}

/// Of what the image spans along the lamps: how far its corners are off what end_coverage() takes
/// it for, 1 at the most.
double bend_along(const CPlaneHit& hit, const Footprint& image, const std::array<double, 4>& at) {
    const auto told = linear_corners(image.dx.x, image.dy.x);
    const auto nearer = linear_corners(image.descent.x, image.descent.y);
    double off = 0;
    for (std::size_t i = 0; i < 4; ++i)
        off = std::max(off, std::abs(at[i] - hit.u - told[i] / (1 + nearer[i])));
    const double span = std::abs(image.dx.x) + std::abs(image.dy.x);
    return std::isfinite(image.reach(0)) ? std::min(off / span, 1.0) : 1.0;
}

bool may_hold_end(const RigPlaneHit& plane, const Footprint& image) {
    const double reach = image.reach(0) + image.widened(end_room(*plane.frame, plane.at.direction));
    const double begin = plane.at.u, end = plane.frame->length - begin;
    return std::abs(begin) < reach || std::abs(end) < reach;
}

} // namespace

std::optional<double> footprint_nonlinearity(const RigPlaneHit& plane, const PixelRays& rays) {
    const CPlaneFrame& frame = *plane.frame;
    const auto across = corners_of(frame, 1, rays);
    if (!across) return {};
    const Footprint image = footprint_on(frame, plane.at, *rays.centre.differentials);
    const auto told = linear_corners(image.dx.y, image.dy.y);
    double off = 0;
    for (std::size_t i = 0; i < 4; ++i)
        off = std::max(off, std::abs((*across)[i] - plane.at.v - told[i]));
    const double bend = off / frame.pitch;
    if (!may_hold_end(plane, image)) return bend;
    return std::max(bend, bend_along(plane.at, image, *corners_of(frame, 0, rays)));
}

} // namespace keiko
