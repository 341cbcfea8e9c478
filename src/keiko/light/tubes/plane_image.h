#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/ray_differentials.h"
#include "keiko/simd/real.h"

#include <limits>

namespace keiko {

/// Intersection of a ray with a C-plane, inside its rectangle or not.
template <class Real>
struct CPlaneHitT {
    Real t = 0;               ///< in lengths of the ray's direction
    Real u = 0, v = 0;        ///< mm from the corner, along and across the lamps
    Vec3T<Real> direction{0}; ///< of the ray, in frame coordinates
};
/// For one ray.
using CPlaneHit = CPlaneHitT<double>;

/// Intersection of a ray's line with the plane. Numbers of a line parallel to it may be infinite or
/// NaN.
template <class Real>
CPlaneHitT<Real> c_plane_hit(const CPlaneFrame& frame, const Vec3T<Real>& origin,
                             const Vec3T<Real>& direction) {
    const Vec3T<Real> o = frame.point(origin), d = frame.vector(direction);
    const Real t = -o.z / d.z;
    return {t, o.x + t * d.x, o.y + t * d.y, d};
}

/// True if the ray itself meets the plane: false for one that points away from it or is within
/// 1e-12 rad of parallel to it (docs/theory/luminance.md#in-mirrors).
template <class Real>
MaskOf<Real> is_met(const CPlaneHitT<Real>& hit) {
    constexpr double parallel = 1e-12;
    return abs(hit.direction.z) > parallel * norm(hit.direction) && hit.t > Real(0);
}

/// A pixel's image on a C-plane, for rays that change linearly with the picture's x and y. A place
/// (x, y) away from the pixel's centre, px, is mapped to the offset
/// (x dx + y dy) / (1 + x descent.x + y descent.y)
/// from the image's centre.
template <class Real>
struct FootprintT {
    /// Derivatives of (u, v) at the centre, mm per pixel; all 0: a point.
    Vec2T<Real> dx{0}, dy{0};
    /// Rate of the component of the rays' direction across the plane, over itself, per pixel; 0:
    /// the image is a parallelogram.
    Vec2T<Real> descent{0};

    /// An axis-parallel box of that extent, mm.
    static FootprintT box(Real du, Real dv) { return {{du, 0}, {0, dv}}; }
    /// True if all derivatives at the centre are 0.
    MaskOf<Real> is_point() const {
        const Real zero = 0;
        return dx.x == zero && dx.y == zero && dy.x == zero && dy.y == zero;
    }
    /// Largest distance from its centre along the lamps, mm; infinite if the plane's horizon runs
    /// through the pixel.
    Real reach_along() const { return widened(half_sum(dx.x, dy.x)); }
    /// Largest image of a `length` at the centre's hit: that at the place of the pixel nearest to
    /// the plane's horizon.
    Real widened(const Real& length) const {
        const Real least = least_descent(), infinite = std::numeric_limits<double>::infinity();
        return select(least > Real(0), length / least, infinite);
    }
    /// Least component of the rays' direction across the plane, over the centre's.
    Real least_descent() const { return 1 - half_sum(descent.x, descent.y); }
};
/// For one pixel.
using Footprint = FootprintT<double>;

/// The footprint of a ray at its `hit` on the plane, to first order: the hit moves with the ray and
/// stays on the plane.
template <class Real>
FootprintT<Real> footprint_on(const CPlaneFrame& frame, const CPlaneHitT<Real>& hit,
                              const RayDifferentialsT<Real>& spread) {
    const Vec3T<Real>& d = hit.direction;
    const Real per_z = 1 / d.z, slope_u = d.x * per_z, slope_v = d.y * per_z;
    const Vec3T<Real> dx = frame.vector(spread.origin_dx + spread.direction_dx * hit.t);
    const Vec3T<Real> dy = frame.vector(spread.origin_dy + spread.direction_dy * hit.t);
    return {{dx.x - slope_u * dx.z, dx.y - slope_v * dx.z},
            {dy.x - slope_u * dy.z, dy.y - slope_v * dy.z},
            {dot(frame.normal, spread.direction_dx) * per_z,
             dot(frame.normal, spread.direction_dy) * per_z}};
}

/// True if the ray starts between the two planes that touch all tubes of the row.
template <class Real>
MaskOf<Real> starts_among_tubes(const CPlaneFrame& frame, const CPlaneHitT<Real>& hit) {
    return hit.t * abs(hit.direction.z) < Real(frame.radius());
}

/// Width in mm of the strip of the C-plane through which rays of direction `d`, in frame
/// coordinates, meet an endless tube (docs/theory/luminance.md#in-mirrors); infinite for a
/// direction in the plane across the lamps.
template <class Real>
Real apparent_diameter(const CPlaneFrame& frame, const Vec3T<Real>& d) {
    return frame.diameter * sqrt(d.y * d.y + d.z * d.z) / abs(d.z);
}

/// Largest apparent shift of an end of a round tube along u, mm, for rays of that direction, in
/// frame coordinates.
template <class Real>
Real end_room(const CPlaneFrame& frame, const Vec3T<Real>& d) {
    return frame.radius() * abs(d.x / d.z);
}

} // namespace keiko
