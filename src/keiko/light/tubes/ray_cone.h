#pragma once

#include "keiko/light/tubes/stripe_coverage.h"

namespace keiko {

/// The rays of a pixel, half a unit of the picture's x and y to all sides of its centre's, each
/// with a footprint of the pixel's size or a smaller one. Only bounds of them are known.
template <class Real>
struct RayConeT {
    Vec3T<Real> origin, direction;  ///< of the centre's ray
    RayDifferentialsT<Real> spread; ///< of that ray
    /// Largest deviations of the other rays from those that the spread predicts.
    Real origin_rest = 0, direction_rest = 0;
    /// Largest deviations of their own differentials from it.
    Real origin_slope_rest = 0, direction_slope_rest = 0;

    /// Largest deviation of an origin from the centre's, mm.
    Real origin_off() const {
        return origin_rest + half_sum(norm(spread.origin_dx), norm(spread.origin_dy));
    }
    /// Largest deviation of a direction from the centre's by the spread alone.
    Real turn() const { return half_sum(norm(spread.direction_dx), norm(spread.direction_dy)); }
};
/// For one pixel.
using RayCone = RayConeT<double>;

/// Bounds of the images of a cone on a plane, in its frame.
///
/// A ray is displaced from the centre's by e where that one meets the plane, at t. It meets the
/// plane itself at e - (d / d.z) e.z from there, d being its own direction. With e = x wx + y wy +
/// rest, the rest counts in full, times 1 + slant. Of wx and wy only their sliding along the plane
/// counts, as in the footprint of the centre.
template <class Real>
class ConeImage {
public:
    /// Image around the centre's `hit`; `least_down`: least component of any direction towards the
    /// plane, above 0.
    ConeImage(const CPlaneFrame& frame, const RayConeT<Real>& rays, const CPlaneHitT<Real>& hit,
              const Real& least_down)
        : slant_((norm(hit.direction) + rays.direction_rest + rays.turn()) / least_down) {
        const RayDifferentialsT<Real>& s = rays.spread;
        const Real tilt = 1 + slant_;
        const Real turn = (rays.direction_rest + rays.turn()) * tilt / least_down; // of d / d.z
        const Real sink_x = dot(frame.normal, s.origin_dx + s.direction_dx * hit.t);
        const Real sink_y = dot(frame.normal, s.origin_dy + s.direction_dy * hit.t);
        const Real sink = half_sum(sink_x, sink_y);
        const Real rest = rays.origin_rest + hit.t * rays.direction_rest;
        const Real later = (rest + sink) / least_down;
        const Real slope_rest = rays.origin_slope_rest +
                                (hit.t + later) * rays.direction_slope_rest +
                                later * max(norm(s.direction_dx), norm(s.direction_dy));
        // Part of the descent of any ray that remains all over its footprint.
        const Real left = 1 - (rays.turn() + rays.direction_slope_rest) / least_down;
        const Real infinite = std::numeric_limits<double>::infinity();
        const Real widening = select(left > Real(0), 1 / left, infinite);
        // Twice: the distance of the images, and half a footprint beyond them.
        const auto room = [&](const Real& by_x, const Real& by_y) {
            const Real images = 2 * (half_sum(by_x, by_y) + turn * sink);
            return (images + (rest + slope_rest) * tilt) * widening;
        };
        const FootprintT<Real> image = footprint_on(frame, hit, s);
        room_u_ = room(image.dx.x, image.dy.x), room_v_ = room(image.dx.y, image.dy.y);
        blur_ = rounding * (sqrt(hit.u * hit.u + hit.v * hit.v) + hit.t * norm(hit.direction) +
                            frame.length + std::abs(frame.last()));
    }

    /// Far more than the rounding of a look-up.
    static constexpr double rounding = 1e-9;

    /// Largest extent of images of tubes along the lamps, mm to each side. Tubes appear wider by
    /// the slant, and their ends bulge by as much.
    Real along(const CPlaneFrame& frame) const { return room_u_ * (1 + rounding) + edge(frame); }
    /// Largest extent across the lamps.
    Real across(const CPlaneFrame& frame) const { return room_v_ * (1 + rounding) + edge(frame); }
    /// Bound of each ray's footprint across the lamps, mm.
    Real footprint() const { return room_v_ + blur_; }

private:
    Real edge(const CPlaneFrame& frame) const {
        return blur_ + (1 + rounding) * frame.radius() * slant_;
    }

    Real slant_; ///< largest length in mm of a ray for each mm towards the plane
    Real room_u_ = 0, room_v_ = 0, blur_ = 0;
};

/// True if everything within `reach` of v is between lamps or beside all of them. A footprint of
/// many pitches contains the mean of the row.
template <class Real>
MaskOf<Real> misses_across(const CPlaneFrame& frame, const Real& v, const Real& reach,
                           const Real& footprint) {
    const Real room = reach + frame.pitch / 2;
    const MaskOf<Real> beside = v < frame.first - room || v > frame.last() + room;
    const Real axis = nearest_lamp(frame, v) * frame.pitch + frame.first;
    const MaskOf<Real> coarse = footprint > Real(frame.pitch);
    return (coarse && beside) || (!coarse && abs(v - axis) > reach);
}

/// True if look_up() is proved to find no lamp of a C-plane for any ray of a cone and its
/// footprint.
template <class Real>
MaskOf<Real> misses_lamps(const CPlaneFrame& frame, const RayConeT<Real>& rays) {
    constexpr double rounding = ConeImage<Real>::rounding;
    const Real zero = 0;
    if (frame.lamps == 0) return zero == zero;
    const CPlaneHitT<Real> hit = c_plane_hit(frame, rays.origin, rays.direction);
    const Real down = abs(hit.direction.z), t = hit.t;
    const Real least_down = down - (rays.direction_rest + rays.turn());
    const MaskOf<Real> sane = least_down > rounding * down;
    const MaskOf<Real> behind = t < zero && abs(t) * down > (1 + 2 * rounding) * rays.origin_off();
    const ConeImage<Real> image(frame, rays, hit, least_down);
    const Real along = image.along(frame), across = image.across(frame);
    const MaskOf<Real> missed = hit.u < -along || hit.u > frame.length + along ||
                                misses_across(frame, hit.v, across, image.footprint());
    const MaskOf<Real> finite = is_finite(along) && is_finite(across);
    return sane && (behind || (t >= zero && finite && missed));
}

} // namespace keiko
