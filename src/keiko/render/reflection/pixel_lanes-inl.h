// Compiled once for each instruction set by lamp_kernels.cpp.
#if defined(KEIKO_RENDER_PIXEL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_RENDER_PIXEL_LANES_INL_H
#undef KEIKO_RENDER_PIXEL_LANES_INL_H
#else
#define KEIKO_RENDER_PIXEL_LANES_INL_H
#endif

#include "keiko/render/reflection/image_lanes-inl.h"
#include "keiko/render/reflection/lamp_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Vectors that begin at a number of the rays, for a vector of places from one on.
inline Space load_space(const ReflectedRays& rays, std::size_t number, std::size_t place) {
    const Wide d;
    return {hn::LoadU(d, rays.at(number, place)), hn::LoadU(d, rays.at(number + 1, place)),
            hn::LoadU(d, rays.at(number + 2, place))};
}

/// Rays of a vector of places from one on, with their derivatives.
inline RayLanes load_rays(const ReflectedRays& rays, std::size_t place) {
    const auto get = [&](std::size_t number) { return load_space(rays, number, place); };
    return {get(ReflectedRays::origin),       get(ReflectedRays::direction),
            get(ReflectedRays::origin_dx),    get(ReflectedRays::origin_dy),
            get(ReflectedRays::direction_dx), get(ReflectedRays::direction_dy)};
}

/// PixelRays, a pixel a lane.
struct PixelLanes {
    RayLanes centre, left, right, above, below; ///< of the pixels and their neighbours

    /// Rays of the pixels from a place on; rows of the picture are `width` long.
    PixelLanes(const ReflectedRays& rays, std::size_t place, std::size_t width)
        : centre(load_rays(rays, place)),
          left(load_rays(rays, place - 1)),
          right(load_rays(rays, place + 1)),
          above(load_rays(rays, place - width)),
          below(load_rays(rays, place + width)) {}
};

/// ReflectedFootprint::bundle without the centre and its spread.
struct BundleLanes {
    Real origin_rest, direction_rest;             ///< as in RayCone
    Real origin_slope_rest, direction_slope_rest; ///< as in RayCone

    /// Bundles of the rays of all parts of the pixels.
    explicit BundleLanes(const PixelLanes& pixel) {
        constexpr double off = 5.0 / 6, slope_off = 2; // as there
        Real origin = real(0), direction = real(0);
        for (const RayLanes* r : {&pixel.left, &pixel.right, &pixel.above, &pixel.below}) {
            const RayLanes& own = pixel.centre;
            origin = hn::Max(origin, hn::Max((r->origin_dx - own.origin_dx).length2(),
                                             (r->origin_dy - own.origin_dy).length2()));
            direction = hn::Max(direction, hn::Max((r->direction_dx - own.direction_dx).length2(),
                                                   (r->direction_dy - own.direction_dy).length2()));
        }
        origin = hn::Sqrt(origin), direction = hn::Sqrt(direction);
        origin_rest = hn::Mul(real(off), origin), direction_rest = hn::Mul(real(off), direction);
        origin_slope_rest = hn::Mul(real(slope_off), origin);
        direction_slope_rest = hn::Mul(real(slope_off), direction);
    }
};

/// True if everything within `reach` of the image is between lamps or beside all of them: as in
/// tube_hit.cpp.
inline Truth misses_across(const CPlaneFrame& frame, Real v, Real reach, Real footprint) {
    const Real first = real(frame.first), last = real(frame.last()), pitch = real(frame.pitch);
    const Real room = hn::Add(reach, real(frame.pitch / 2));
    const Truth beside = hn::Or(hn::Lt(v, hn::Sub(first, room)), hn::Gt(v, hn::Add(last, room)));
    const Real nearest = hn::Floor(hn::Add(hn::Div(hn::Sub(v, first), pitch), real(0.5)));
    const Real lamp = hn::Min(hn::Max(nearest, real(0)), real(frame.lamps - 1.0));
    const Truth between = hn::Gt(hn::Abs(hn::Sub(v, hn::MulAdd(lamp, pitch, first))), reach);
    const Truth coarse = hn::Gt(footprint, pitch);
    return hn::Or(hn::And(coarse, beside), hn::AndNot(coarse, between));
}

/// misses_lamps() of the pixels' bundles.
inline Truth misses_lamps(const CPlaneFrame& frame, const PixelLanes& pixel,
                          const ImageLanes& image) {
    constexpr double rounding = 1e-9;
    const Wide lanes;
    if (frame.lamps == 0) return hn::FirstN(lanes, hn::Lanes(lanes));
    const BundleLanes bundle(pixel);
    const RayLanes& own = pixel.centre;
    const Real one = real(1);
    const Space& d = image.direction;
    const Real dx_length = own.direction_dx.length(), dy_length = own.direction_dy.length();
    const Real off = hn::Add(bundle.direction_rest, half_sum(dx_length, dy_length));
    const Real down = hn::Abs(d.z), least_down = hn::Sub(down, off);
    const Truth sane = hn::Gt(least_down, hn::Mul(real(rounding), down));
    const Real per_down = hn::Div(one, least_down);

    const Real height = hn::Abs(hn::Mul(image.t, d.z));
    const Real origin_off =
        hn::Add(bundle.origin_rest, half_sum(own.origin_dx.length(), own.origin_dy.length()));
    const Truth behind = hn::And(hn::Lt(image.t, real(0)),
                                 hn::Gt(height, hn::Mul(real(1 + 2 * rounding), origin_off)));

    const Real slant = hn::Mul(hn::Add(d.length(), off), per_down), tilt = hn::Add(one, slant);
    const Real turn = hn::Mul(hn::Mul(off, tilt), per_down);
    const Real rest = hn::MulAdd(image.t, bundle.direction_rest, bundle.origin_rest);
    const Real sink = half_sum(image.dx.z, image.dy.z);
    const Real later = hn::Mul(hn::Add(rest, sink), per_down);
    const Real slope_rest =
        hn::MulAdd(hn::Add(image.t, later), bundle.direction_slope_rest,
                   hn::MulAdd(later, hn::Max(dx_length, dy_length), bundle.origin_slope_rest));
    const Real beyond = hn::Mul(hn::Add(rest, slope_rest), tilt);
    const Real turn_within = hn::Add(half_sum(dx_length, dy_length), bundle.direction_slope_rest);
    const Real left = hn::NegMulAdd(turn_within, per_down, one);
    const Real widening = hn::IfThenElse(hn::Gt(left, real(0)), hn::Div(one, left), hn::Inf(lanes));
    const auto room = [&](Real by_x, Real by_y) {
        const Real images =
            hn::MulAdd(real(2), hn::MulAdd(turn, sink, half_sum(by_x, by_y)), beyond);
        return hn::Mul(images, widening);
    };
    const Real room_u = room(image.u_dx, image.u_dy), room_v = room(image.v_dx, image.v_dy);
    const Real size =
        hn::Add(hn::Sqrt(hn::MulAdd(image.at.x, image.at.x, hn::Mul(image.at.y, image.at.y))),
                hn::Add(hn::Abs(hn::Mul(image.t, d.length())),
                        real(frame.length + std::abs(frame.last()))));
    const Real blur = hn::Mul(real(2 * rounding), size);
    const Real bulge = hn::Mul(real((1 + rounding) * frame.radius()), slant);
    const auto padded = [&](Real r) {
        return hn::MulAdd(r, real(1 + 2 * rounding), hn::Add(blur, bulge));
    };
    const Real along = padded(room_u), across = padded(room_v);
    const Truth finite = hn::And(hn::IsFinite(along), hn::IsFinite(across));
    const Truth beside = hn::Or(hn::Lt(image.at.x, hn::Neg(along)),
                                hn::Gt(image.at.x, hn::Add(real(frame.length), along)));
    const Truth missed =
        hn::Or(beside, misses_across(frame, image.at.y, across, hn::Add(room_v, blur)));
    const Truth ahead = hn::And(hn::Ge(image.t, real(0)), hn::And(finite, missed));
    return hn::And(sane, hn::Or(behind, ahead));
}

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
    SliceLanes(const Space& o, const Space& d, unsigned axis)
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
                                         const Space& direction, unsigned axis) {
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
    const auto off = [](const Space& value, const Space& own, const Space& there,
                        const Space& opposite, double side, const Space& is) {
        // The cubic a step to one side: its slope there and at the opposite neighbour are
        // sufficient.
        const Space bend = (there - opposite).scaled(side * 0.5);
        const Space turn = there.plus(-2, own) + opposite;
        const Space told = value.plus(side, own).plus(0.5, bend).plus(side / 6, turn);
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

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
