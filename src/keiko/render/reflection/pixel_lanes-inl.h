// Compiled once for each instruction set by lamp_kernels.cpp.
#if defined(KEIKO_RENDER_PIXEL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_RENDER_PIXEL_LANES_INL_H
#undef KEIKO_RENDER_PIXEL_LANES_INL_H
#else
#define KEIKO_RENDER_PIXEL_LANES_INL_H
#endif

#include "keiko/render/reflection/image_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Part of a ray, or of a derivative of one, that determines its intersection with a plane along
/// one of its axes: see reflected_footprint.cpp.
struct SliceLanes {
    Real origin, origin_height;       ///< along the axis, and along the normal
    Real direction, direction_height; ///< along the axis, and along the normal

    /// Slice of these components.
    SliceLanes(Real o, Real o_height, Real d, Real d_height)
        : origin(o), origin_height(o_height), direction(d), direction_height(d_height) {}
    /// Slice of an origin and a direction in the plane's frame; `axis` 0 is along the lamps, 1
    /// across.
    SliceLanes(const VectorLanes& o, const VectorLanes& d, unsigned axis)
        : SliceLanes(axis == 0 ? o.x : o.y, o.z, axis == 0 ? d.x : d.y, d.z) {}

    /// Sum of all components.
    SliceLanes operator+(const SliceLanes& o) const {
        return {hn::Add(origin, o.origin), hn::Add(origin_height, o.origin_height),
                hn::Add(direction, o.direction), hn::Add(direction_height, o.direction_height)};
    }
    /// Difference of all components.
    SliceLanes operator-(const SliceLanes& o) const {
        return {hn::Sub(origin, o.origin), hn::Sub(origin_height, o.origin_height),
                hn::Sub(direction, o.direction), hn::Sub(direction_height, o.direction_height)};
    }
    /// Product of all components and a number.
    SliceLanes operator*(double s) const {
        return {hn::Mul(origin, real(s)), hn::Mul(origin_height, real(s)),
                hn::Mul(direction, real(s)), hn::Mul(direction_height, real(s))};
    }
};

/// Slopes by the picture's x and y.
struct SliceSlopes {
    SliceLanes x, y; ///< a pixel

    /// Slopes of rays along an axis of a plane.
    SliceSlopes(const FrameLanes& frame, const RayLanes& rays, unsigned axis)
        : x(frame.vector(rays.origin_dx), frame.vector(rays.direction_dx), axis),
          y(frame.vector(rays.origin_dy), frame.vector(rays.direction_dy), axis) {}
};

/// CubicFootprint::corners. That template itself is independent of instruction sets.
inline std::array<SliceLanes, 4> corners(const FrameLanes& frame, const PixelLanes& pixel,
                                         const VectorLanes& direction, unsigned axis) {
    const SliceLanes value(frame.point(pixel.centre.origin), direction, axis);
    const SliceSlopes own(frame, pixel.centre, axis), left(frame, pixel.left, axis),
        right(frame, pixel.right, axis), above(frame, pixel.above, axis),
        below(frame, pixel.below, axis);
    const SliceLanes bends = right.x - left.x + below.y - above.y;
    const SliceLanes twisted = (below.x - above.x + right.y - left.y) * (1.0 / 16);
    const auto odd = [](const SliceLanes& slope, const SliceLanes& along_less,
                        const SliceLanes& along_more, const SliceLanes& aside_less,
                        const SliceLanes& aside_more) {
        return slope * (0.5 - 2.0 / 48 - 2.0 / 16) + (along_less + along_more) * (1.0 / 48) +
               (aside_less + aside_more) * (1.0 / 16);
    };
    const SliceLanes across = odd(own.x, left.x, right.x, above.x, below.x);
    const SliceLanes along = odd(own.y, above.y, below.y, left.y, right.y);
    const SliceLanes even = value + bends * (1.0 / 16), up = even - along, down = even + along;
    return {up + twisted - across, up - twisted + across, down - twisted - across,
            down + twisted + across};
}

/// Values of a linear function at the corners of a pixel at whose centre it is 0.
inline std::array<Real, 4> linear_corners(Real by_x, Real by_y) {
    const Real sum = hn::Mul(real(0.5), hn::Add(by_x, by_y));
    const Real rise = hn::Mul(real(0.5), hn::Sub(by_x, by_y));
    return {hn::Neg(sum), rise, hn::Neg(rise), sum};
}

/// footprint_nonlinearity(), and the lanes where it has a value.
struct BendLanes {
    Real bend = real(0);                                   ///< for lanes of `bounded`
    Truth bounded = hn::FirstN(Wide(), hn::Lanes(Wide())); ///< rays of all corners meet the plane

    /// Bend of the images of pixels on a plane; `image` is that of the rays of their centres.
    BendLanes(const CPlaneFrame& plane, const FrameLanes& frame, const PixelLanes& pixel,
              const ImageLanes& image) {
        const auto told = linear_corners(image.v_dx, image.v_dy);
        const std::array<SliceLanes, 4> at = corners(frame, pixel, image.direction, 1);
        for (std::size_t i = 0; i < 4; ++i) {
            const Real t = hn::Neg(hn::Div(at[i].origin_height, at[i].direction_height));
            bounded = hn::And(bounded, hn::And(hn::Gt(t, real(0)), hn::IsFinite(t)));
            const Real v = hn::MulAdd(t, at[i].direction, at[i].origin);
            bend = hn::Max(bend, hn::Abs(hn::Sub(v, hn::Add(told[i], image.at.y))));
        }
        bend = hn::Div(bend, real(plane.pitch));
        const Real reach = image.reach_along();
        const Real near_end = hn::Add(reach, image.widened(end_room(plane, image.direction)));
        const Truth begin = hn::Lt(hn::Abs(image.at.x), near_end);
        const Truth end = hn::Lt(hn::Abs(hn::Sub(real(plane.length), image.at.x)), near_end);
        const Truth at_ends = hn::And(bounded, hn::Or(begin, end));
        if (hn::AllFalse(Wide(), at_ends)) return;
        const Real along =
            hn::IfThenElse(hn::IsFinite(reach), bend_along(frame, pixel, image), real(1));
        bend = hn::IfThenElse(at_ends, hn::Max(bend, along), bend);
    }

private:
    /// Counterpart of bend_along() in reflected_footprint.cpp.
    static Real bend_along(const FrameLanes& frame, const PixelLanes& pixel,
                           const ImageLanes& image) {
        const auto told = linear_corners(image.u_dx, image.u_dy);
        const auto nearer = linear_corners(image.descent_x, image.descent_y);
        const std::array<SliceLanes, 4> at = corners(frame, pixel, image.direction, 0);
        Real off = real(0);
        for (std::size_t i = 0; i < 4; ++i) {
            const Real t = hn::Neg(hn::Div(at[i].origin_height, at[i].direction_height));
            const Real u = hn::MulAdd(t, at[i].direction, at[i].origin);
            const Real from = hn::Div(told[i], hn::Add(real(1), nearer[i]));
            off = hn::Max(off, hn::Abs(hn::Sub(u, hn::Add(from, image.at.x))));
        }
        const Real span = hn::Add(hn::Abs(image.u_dx), hn::Abs(image.u_dy));
        return hn::Min(hn::Div(off, span), real(1));
    }
};

/// ReflectedFootprint::residual().
inline Real residual(const PixelLanes& pixel, Real t) {
    const auto off = [](const VectorLanes& value, const VectorLanes& own, const VectorLanes& there,
                        const VectorLanes& opposite, double side, const VectorLanes& is) {
        // The cubic a step to one side: its slope there and at the opposite neighbour are
        // sufficient.
        const VectorLanes bend = (there - opposite).scaled(side * 0.5);
        const VectorLanes turn = there.plus(-2, own) + opposite;
        const VectorLanes told = value.plus(side, own).plus(0.5, bend).plus(side / 6, turn);
        return (told - is).length2();
    };
    const RayLanes &c = pixel.centre, &l = pixel.left, &r = pixel.right, &a = pixel.above,
                   &b = pixel.below;
    const auto most = [](Real p, Real q, Real x, Real y) {
        return hn::Sqrt(hn::Max(hn::Max(p, q), hn::Max(x, y)));
    };
    const Real origin = most(off(c.origin, c.origin_dx, l.origin_dx, r.origin_dx, -1, l.origin),
                             off(c.origin, c.origin_dx, r.origin_dx, l.origin_dx, 1, r.origin),
                             off(c.origin, c.origin_dy, a.origin_dy, b.origin_dy, -1, a.origin),
                             off(c.origin, c.origin_dy, b.origin_dy, a.origin_dy, 1, b.origin));
    const Real direction =
        most(off(c.direction, c.direction_dx, l.direction_dx, r.direction_dx, -1, l.direction),
             off(c.direction, c.direction_dx, r.direction_dx, l.direction_dx, 1, r.direction),
             off(c.direction, c.direction_dy, a.direction_dy, b.direction_dy, -1, a.direction),
             off(c.direction, c.direction_dy, b.direction_dy, a.direction_dy, 1, b.direction));
    return hn::MulAdd(t, direction, origin);
}

/// ReflectedFootprint of one pixel, with a part of it a lane.
class CubicLanes {
public:
    /// Cubic of the ray of a place, from the rays of its four neighbours; rows of the picture are
    /// `width` long. The place is not at the border of the grid.
    CubicLanes(const ReflectedRays& rays, std::size_t place, std::size_t width)
        : origin_(rays, {ReflectedRays::origin, ReflectedRays::origin_dx, ReflectedRays::origin_dy},
                  place, width),
          direction_(
              rays,
              {ReflectedRays::direction, ReflectedRays::direction_dx, ReflectedRays::direction_dy},
              place, width) {}

    /// The rays of parts of `share` times the width and height around places in the pixel.
    RayLanes part(Real x, Real y, double share) const {
        const Terms terms(x, y);
        return {origin_.value(terms),
                direction_.value(terms),
                origin_.by_x(terms).scaled(share),
                origin_.by_y(terms).scaled(share),
                direction_.by_x(terms).scaled(share),
                direction_.by_y(terms).scaled(share)};
    }

private:
    struct Terms {
        Real x, y, xx, xy, yy; ///< squares halved

        Terms(Real at_x, Real at_y)
            : x(at_x),
              y(at_y),
              xx(hn::Mul(hn::Mul(at_x, at_x), real(0.5))),
              xy(hn::Mul(at_x, at_y)),
              yy(hn::Mul(hn::Mul(at_y, at_y), real(0.5))) {}
    };
    /// Index of a vector and of its slopes among the numbers of a ray.
    struct Numbers {
        std::size_t value, dx, dy;
    };

    /// CubicFootprint of a vector.
    class Cubic {
    public:
        Cubic(const ReflectedRays& rays, const Numbers& numbers, std::size_t place,
              std::size_t width) {
            const auto all = [&](std::size_t number, std::size_t at) {
                const auto one = [&](std::size_t k) { return real(*rays.at(number + k, at)); };
                return VectorLanes{one(0), one(1), one(2)};
            };
            const auto dx = [&](std::size_t at) { return all(numbers.dx, at); };
            const auto dy = [&](std::size_t at) { return all(numbers.dy, at); };
            const std::size_t left = place - 1, right = place + 1, above = place - width,
                              below = place + width;
            value_ = all(numbers.value, place), x_ = dx(place), y_ = dy(place);
            xx_ = (dx(right) - dx(left)).scaled(0.5);
            xy_ = (dx(below) - dx(above) + dy(right) - dy(left)).scaled(0.25);
            yy_ = (dy(below) - dy(above)).scaled(0.5);
            xxx_ = dx(right).plus(-2, x_) + dx(left);
            xxy_ = dy(right).plus(-2, y_) + dy(left);
            xyy_ = dx(below).plus(-2, x_) + dx(above);
            yyy_ = dy(below).plus(-2, y_) + dy(above);
        }
        VectorLanes value(const Terms& at) const {
            const Real third = real(1.0 / 3);
            return value_.plus(at.x, x_)
                .plus(at.y, y_)
                .plus(at.xx, xx_)
                .plus(at.xy, xy_)
                .plus(at.yy, yy_)
                .plus(hn::Mul(hn::Mul(at.xx, at.x), third), xxx_)
                .plus(hn::Mul(at.xx, at.y), xxy_)
                .plus(hn::Mul(at.yy, at.x), xyy_)
                .plus(hn::Mul(hn::Mul(at.yy, at.y), third), yyy_);
        }
        VectorLanes by_x(const Terms& at) const {
            return x_.plus(at.x, xx_)
                .plus(at.y, xy_)
                .plus(at.xx, xxx_)
                .plus(at.xy, xxy_)
                .plus(at.yy, xyy_);
        }
        VectorLanes by_y(const Terms& at) const {
            return y_.plus(at.x, xy_)
                .plus(at.y, yy_)
                .plus(at.xx, xxy_)
                .plus(at.xy, xyy_)
                .plus(at.yy, yyy_);
        }

    private:
        VectorLanes value_, x_, y_, xx_, xy_, yy_, xxx_, xxy_, xyy_, yyy_;
    };

    Cubic origin_, direction_;
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
