#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/ray_differentials.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {

/// Image of a pixel's square along one axis of the C-plane if the map from picture to plane is
/// linear across the pixel. It is the convolution of two boxes of widths |du/dx| and |du/dy|, a
/// trapezoid of unit area. Both widths 0: a point.
class PixelFilter {
public:
    /// Filter of two widths in mm, of either sign.
    PixelFilter(double by_x, double by_y)
        : wide_(std::max(std::abs(by_x), std::abs(by_y))),
          narrow_(std::min(std::abs(by_x), std::abs(by_y))) {}

    /// Share of the filter that lies in [begin, end], positions relative to its centre; 0 to 1.
    double share(double begin, double end) const {
        return begin < end ? below(end) - below(begin) : 0;
    }
    /// Largest distance of the filter from its centre, mm.
    double reach() const { return (wide_ + narrow_) / 2; }
    /// Wider of the two boxes, mm.
    double width() const { return wide_; }

private:
    /// Integral of the filter up to x.
    double below(double x) const { return 0.5 + std::copysign(half(std::abs(x)), x); }
    /// Integral of the filter from 0 to x >= 0.
    double half(double x) const {
        if (x >= reach()) return 0.5;
        if (x <= reach() - narrow_) return x / wide_;
        const double rest = reach() - x;
        return 0.5 - rest * rest / (2 * wide_ * narrow_);
    }

    double wide_, narrow_;
};

/// Share of a filter centred at v = `center` mm that falls on the row's strips of `strip_width` mm,
/// 0 to 1: exact for any filter (docs/theory.md#stripes-without-noise). Strips that overlap count
/// as one.
double comb_coverage(const CPlaneFrame& frame, double strip_width, double center,
                     const PixelFilter& filter);

/// Share of a filter for stripes too fine to be distinguished: the row as a grey band.
double mean_coverage(const CPlaneFrame& frame, double strip_width, double center,
                     const PixelFilter& filter);

/// Intersection of a ray with a C-plane, inside its rectangle or not.
struct CPlaneHit {
    double t = 0;        ///< in lengths of the ray's direction, > 0
    double u = 0, v = 0; ///< mm from the corner, along and across the lamps
    Vec3 direction{0};   ///< of the ray, in frame coordinates
};

/// Intersection of a ray with the plane; nullopt for a ray that points away from the plane or is
/// within 1e-12 rad of parallel to it.
std::optional<CPlaneHit> c_plane_coordinates(const CPlaneFrame& frame, const Vec3& origin,
                                             const Vec3& direction);
std::optional<CPlaneHit> c_plane_coordinates(const CPlane& plane, const Vec3& origin,
                                             const Vec3& direction);

/// A pixel's image on a C-plane, for rays that change linearly with the picture's x and y. A place
/// (x, y) away from the pixel's centre, px, is mapped to the offset
/// (x dx + y dy) / (1 + x descent.x + y descent.y)
/// from the image's centre.
struct Footprint {
    Vec2 dx{0}, dy{0}; ///< derivatives of (u, v) at the centre, mm per pixel; all 0: a point
    /// Rate of the component of the rays' direction across the plane, over itself, per pixel; 0:
    /// the image is a parallelogram.
    Vec2 descent{0};

    /// An axis-parallel box of that extent, mm.
    static Footprint box(double du, double dv) { return {{du, 0}, {0, dv}}; }
    /// True if all derivatives at the centre are 0.
    bool is_point() const { return dx == Vec2(0) && dy == Vec2(0); }
    /// Largest distance from its centre along an axis of the plane, mm; infinite if the plane's
    /// horizon runs through the pixel.
    double reach(unsigned axis) const;
    /// Largest image of a `length` at the centre's hit: that at the place of the pixel nearest to
    /// the plane's horizon.
    double widened(double length) const;
};

/// True if the ray starts between the two planes that touch all tubes of the row.
bool starts_among_tubes(const CPlaneFrame& frame, const CPlaneHit& hit);

/// The footprint of a ray at its `hit` on the plane, to first order.
Footprint footprint_on(const CPlaneFrame& frame, const CPlaneHit& hit,
                       const RayDifferentials& spread);

/// Share of a reflected ray, or of a pixel of them, that a row of lamps fills.
struct LampCoverage {
    double coverage = 0;  ///< share of the pixel that lamps fill, 0 to 1
    bool resolved = true; ///< false: over 4 pitches in a pixel; the coverage is the mean
};

/// Coverage of a ray or pixel by the lamps on the plane (docs/theory/luminance.md#in-mirrors); both
/// sides of it are visible. A point is intersected exactly, end caps included. A footprint is
/// integrated in closed form over strips of the tubes' apparent width up to the images of their
/// rims, or (exact) is the mean over 256 parallel rays. The light between the lamps and occluders
/// before them are the caller's task.
LampCoverage look_up(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction,
                     const Footprint& footprint = {}, MirrorModel look = MirrorModel::tube);
/// Coverage of a ray that is known to meet the plane at `hit`.
LampCoverage look_up(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin,
                     const Vec3& direction, const Footprint& footprint, MirrorModel look);

/// Luminance in cd/m2 of a row of lamps along a ray, darkness between the lamps.
Rgb mirrored_luminance(const CPlane& plane, const Vec3& origin, const Vec3& direction,
                       const Footprint& footprint = {}, MirrorModel look = MirrorModel::tube);

/// The strip that holds the point (u, v), by rising v; nullopt between the strips. `width` in mm.
std::optional<int> strip_at(const CPlaneFrame& frame, double u, double v, double width);

} // namespace keiko
