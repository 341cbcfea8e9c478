#pragma once

#include "keiko/render/reflection/reflected_footprint.h"

#include <array>

namespace keiko {

/// Part of a ray, or of a derivative of one, that determines its intersection with a plane along
/// one of its axes: the components along that axis and the plane's normal of origin and direction.
template <class Real>
struct RaySlice {
    Real origin, origin_height;       ///< along the axis, and along the normal
    Real direction, direction_height; ///< along the axis, and along the normal

    RaySlice operator+(const RaySlice& o) const {
        return {origin + o.origin, origin_height + o.origin_height, direction + o.direction,
                direction_height + o.direction_height};
    }
    RaySlice operator-(const RaySlice& o) const {
        return {origin - o.origin, origin_height - o.origin_height, direction - o.direction,
                direction_height - o.direction_height};
    }
    RaySlice operator*(double s) const {
        return {origin * s, origin_height * s, direction * s, direction_height * s};
    }
    /// Parameter of the ray where it meets the plane.
    Real t() const { return -origin_height / direction_height; }
    /// Place along the axis at a parameter, mm.
    Real at(const Real& t) const { return origin + t * direction; }
};

/// Rays of the corners of a pixel along an axis of a plane, row by row.
template <class Real>
std::array<RaySlice<Real>, 4> corner_slices(const CPlaneFrame& frame, const Vec3& axis,
                                            const PixelRaysT<Real>& rays) {
    using Slice = RaySlice<Real>;
    const auto of = [&](const Vec3T<Real>& origin, const Vec3T<Real>& direction) {
        return Slice{dot(axis, origin), dot(frame.normal, origin), dot(axis, direction),
                     dot(frame.normal, direction)};
    };
    const auto slopes = [&](const PixelRayT<Real>& ray) {
        const RayDifferentialsT<Real>& d = ray.spread;
        return Slopes<Slice>{of(d.origin_dx, d.direction_dx), of(d.origin_dy, d.direction_dy)};
    };
    const Slice value = of(rays.centre.origin - Vec3T<Real>(frame.origin), rays.centre.direction);
    return CubicFootprint<Slice>(value, slopes(rays.centre), slopes(rays.left), slopes(rays.right),
                                 slopes(rays.above), slopes(rays.below))
        .corners();
}

/// Values of a linear function at the corners of a pixel at whose centre it is 0, row by row.
template <class Real>
std::array<Real, 4> linear_corners(const Real& by_x, const Real& by_y) {
    const Real sum = (by_x + by_y) * 0.5, rise = (by_x - by_y) * 0.5;
    return {-sum, rise, -rise, sum};
}

/// Deviation of the corners of a pixel's image along the lamps from the image assumed by
/// end_coverage(), as a share of its span, at most 1.
template <class Real>
Real bend_along(const CPlaneFrame& frame, const PixelRaysT<Real>& rays, const CPlaneHitT<Real>& hit,
                const FootprintT<Real>& image) {
    const auto told = linear_corners<Real>(image.dx.x, image.dy.x);
    const auto nearer = linear_corners<Real>(image.descent.x, image.descent.y);
    const auto corners = corner_slices(frame, frame.u, rays);
    Real off = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Real u = corners[i].at(corners[i].t());
        off = max(off, abs(u - hit.u - told[i] / (1 + nearer[i])));
    }
    const Real share = min(off / (abs(image.dx.x) + abs(image.dy.x)), Real(1));
    return select(is_finite(image.reach_along()), share, Real(1));
}

/// Deviation of the corners of a pixel's image on a C-plane, by the cubic through its reflected
/// rays, from the centre's differentials. It is stated across the lamps, in pitches. If an end of
/// lamps may be in the image, it is also stated along them, as a share of its span.
template <class Real>
struct ImageBend {
    Real bend = 0;        ///< where it is bounded
    MaskOf<Real> bounded; ///< the rays of all corners meet the plane

    /// Bend of the `image` of rays around the centre's hit.
    ImageBend(const CPlaneFrame& frame, const PixelRaysT<Real>& rays, const CPlaneHitT<Real>& hit,
              const FootprintT<Real>& image)
        : bounded(true) {
        const auto told = linear_corners<Real>(image.dx.y, image.dy.y);
        const auto corners = corner_slices(frame, frame.v, rays);
        for (std::size_t i = 0; i < 4; ++i) {
            const Real t = corners[i].t();
            bounded = bounded && t > Real(0) && is_finite(t);
            bend = max(bend, abs(corners[i].at(t) - hit.v - told[i]));
        }
        bend = bend / frame.pitch;
        const MaskOf<Real> at_ends = bounded && may_hold_end(frame, hit, image);
        if (any_of(at_ends))
            bend = select(at_ends, max(bend, bend_along(frame, rays, hit, image)), bend);
    }

private:
    static MaskOf<Real> may_hold_end(const CPlaneFrame& frame, const CPlaneHitT<Real>& hit,
                                     const FootprintT<Real>& image) {
        const Real reach = image.reach_along() + image.widened(end_room(frame, hit.direction));
        return abs(hit.u) < reach || abs(frame.length - hit.u) < reach;
    }
};

} // namespace keiko
