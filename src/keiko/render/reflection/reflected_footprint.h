#pragma once

#include "keiko/light/tubes/ray_cone.h"

#include <array>

namespace keiko {

/// Derivatives of a quantity by the picture's x and y, per pixel.
template <class Jet>
struct Slopes {
    Jet x, y; ///< by x, to the right, and by y, down
};

/// A smooth quantity in a picture as a cubic in the place around a pixel's centre: by Taylor's
/// theorem from its value there and its slopes there and at the centres of four neighbours. `Jet`:
/// the value, or a derivative of it; it has +, - and * by a number.
template <class Jet>
class CubicFootprint {
public:
    /// Cubic with the value and the slopes of a pixel's centre, bent by the neighbours' slopes.
    CubicFootprint(const Jet& value, const Slopes<Jet>& centre, const Slopes<Jet>& left,
                   const Slopes<Jet>& right, const Slopes<Jet>& above, const Slopes<Jet>& below)
        : value_(value),
          x_(centre.x),
          y_(centre.y),
          xx_((right.x - left.x) * 0.5),
          xy_((below.x - above.x + right.y - left.y) * 0.25),
          yy_((below.y - above.y) * 0.5),
          xxx_(right.x - x_ * 2 + left.x),
          xxy_(right.y - y_ * 2 + left.y),
          xyy_(below.x - x_ * 2 + above.x),
          yyy_(below.y - y_ * 2 + above.y) {}

    /// Value at a place relative to the centre, in pixels.
    template <class Real>
    Jet at(const Real& x, const Real& y) const {
        const Real xx = x * x * 0.5, yy = y * y * 0.5;
        return value_ + x_ * x + y_ * y + xx_ * xx + xy_ * (x * y) + yy_ * yy +
               xxx_ * (xx * x * (1.0 / 3)) + xxy_ * (xx * y) + xyy_ * (x * yy) +
               yyy_ * (yy * y * (1.0 / 3));
    }
    /// Values at the pixel's corners, row by row.
    std::array<Jet, 4> corners() const {
        const Jet even = value_ + (xx_ + yy_) * (1.0 / 8), twisted = xy_ * (1.0 / 4);
        const Jet across = x_ * 0.5 + xxx_ * (1.0 / 48) + xyy_ * (1.0 / 16);
        const Jet along = y_ * 0.5 + yyy_ * (1.0 / 48) + xxy_ * (1.0 / 16);
        const Jet up = even - along, down = even + along;
        return {up + twisted - across, up - twisted + across, down - twisted - across,
                down + twisted + across};
    }
    /// Values at the centres of the neighbours: left, right, above, below.
    std::array<Jet, 4> neighbours() const {
        const Jet even_x = value_ + xx_ * 0.5, odd_x = x_ + xxx_ * (1.0 / 6);
        const Jet even_y = value_ + yy_ * 0.5, odd_y = y_ + yyy_ * (1.0 / 6);
        return {even_x - odd_x, even_x + odd_x, even_y - odd_y, even_y + odd_y};
    }
    /// Slopes at a place relative to the centre, in pixels.
    template <class Real>
    Slopes<Jet> slopes(const Real& x, const Real& y) const {
        const Real xx = x * x * 0.5, xy = x * y, yy = y * y * 0.5;
        return {x_ + xx_ * x + xy_ * y + xxx_ * xx + xxy_ * xy + xyy_ * yy,
                y_ + xy_ * x + yy_ * y + xxy_ * xx + xyy_ * xy + yyy_ * yy};
    }

private:
    Jet value_, x_, y_, xx_, xy_, yy_, xxx_, xxy_, xyy_, yyy_;
};

/// The reflected ray of a pixel, or of a part of one.
template <class Real>
struct PixelRayT {
    Vec3T<Real> origin, direction;  ///< world, mm; the direction of any length
    RayDifferentialsT<Real> spread; ///< by the pixel's or the part's own width and height
};
/// For one pixel.
using PixelRay = PixelRayT<double>;

/// The reflected rays of a pixel's centre and of its neighbours', all on one smooth surface.
template <class Real>
struct PixelRaysT {
    PixelRayT<Real> centre, left, right, above, below; ///< of the pixel and its neighbours
};
/// For one pixel.
using PixelRays = PixelRaysT<double>;

/// A pixel's reflected rays as a cubic in the place in the picture.
template <class Real>
class ReflectedFootprintT {
public:
    /// Footprint of a pixel by its own rays and the neighbours'.
    explicit ReflectedFootprintT(const PixelRaysT<Real>& rays)
        : cubic_({rays.centre.origin, rays.centre.direction}, slopes_of(rays.centre),
                 slopes_of(rays.left), slopes_of(rays.right), slopes_of(rays.above),
                 slopes_of(rays.below)) {}

    /// The ray of a pixel of `share` times the width and height around a place relative to the
    /// centre, in pixels.
    PixelRayT<Real> part(const Real& x, const Real& y, double share) const {
        const Jet value = cubic_.at(x, y);
        const Slopes<Jet> by = cubic_.slopes(x, y);
        return {value.origin,
                value.direction,
                {by.x.origin * share, by.y.origin * share, by.x.direction * share,
                 by.y.direction * share}};
    }
    /// Largest deviation of the neighbours' rays from the cubic, mm, where they pass the plane that
    /// the centre's ray meets at t. It is large where the surface's curvature jumps.
    Real residual(const PixelRaysT<Real>& rays, const Real& t) const {
        const std::array<Jet, 4> told = cubic_.neighbours();
        const std::array<const PixelRayT<Real>*, 4> is{&rays.left, &rays.right, &rays.above,
                                                       &rays.below};
        Real origin = 0, direction = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            origin = max(origin, (told[i].origin - is[i]->origin).length2());
            direction = max(direction, (told[i].direction - is[i]->direction).length2());
        }
        return sqrt(origin) + t * sqrt(direction);
    }

private:
    /// Origin and direction, or a derivative of them.
    struct Jet {
        Vec3T<Real> origin, direction;

        Jet operator+(const Jet& o) const { return {origin + o.origin, direction + o.direction}; }
        Jet operator-(const Jet& o) const { return {origin - o.origin, direction - o.direction}; }
        Jet operator*(const Real& s) const { return {origin * s, direction * s}; }
    };
    static Slopes<Jet> slopes_of(const PixelRayT<Real>& ray) {
        const RayDifferentialsT<Real>& d = ray.spread;
        return {{d.origin_dx, d.direction_dx}, {d.origin_dy, d.direction_dy}};
    }

    CubicFootprint<Jet> cubic_;
};
/// For one pixel.
using ReflectedFootprint = ReflectedFootprintT<double>;

/// Bounds of the rays of all parts of a pixel, itself included. With m the largest deviation of
/// neighbours' slopes from the centre's, the second derivatives of the cubic are at most m, the
/// third at most 2 m. The pixel extends half a unit to all sides: that adds up to
/// 1/8 + 1/8 + 1/4 + 4/48 + 4/16 times m. For the slopes it adds up to 1/2 + 1/2 + 2/8 + 2/4 + 2/8.
template <class Real>
RayConeT<Real> cone_of(const PixelRaysT<Real>& rays) {
    constexpr double off = 5.0 / 6, slope_off = 2;
    const RayDifferentialsT<Real>& own = rays.centre.spread;
    Real origin = 0, direction = 0; // squared
    for (const PixelRayT<Real>* neighbour : {&rays.left, &rays.right, &rays.above, &rays.below}) {
        const RayDifferentialsT<Real>& d = neighbour->spread;
        origin = max(origin, max((d.origin_dx - own.origin_dx).length2(),
                                 (d.origin_dy - own.origin_dy).length2()));
        direction = max(direction, max((d.direction_dx - own.direction_dx).length2(),
                                       (d.direction_dy - own.direction_dy).length2()));
    }
    origin = sqrt(origin), direction = sqrt(direction);
    return {rays.centre.origin, rays.centre.direction, own, off * origin, off * direction,
            slope_off * origin, slope_off * direction};
}

} // namespace keiko
