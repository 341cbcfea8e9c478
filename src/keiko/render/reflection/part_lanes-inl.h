// Compiled once for each instruction set by lamp_kernels.cpp.
#if defined(KEIKO_RENDER_PART_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_RENDER_PART_LANES_INL_H
#undef KEIKO_RENDER_PART_LANES_INL_H
#else
#define KEIKO_RENDER_PART_LANES_INL_H
#endif

#include "keiko/render/reflection/stripe_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

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
                return Space{one(0), one(1), one(2)};
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
        Space value(const Terms& at) const {
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
        Space by_x(const Terms& at) const {
            return x_.plus(at.x, xx_)
                .plus(at.y, xy_)
                .plus(at.xx, xxx_)
                .plus(at.xy, xxy_)
                .plus(at.yy, xyy_);
        }
        Space by_y(const Terms& at) const {
            return y_.plus(at.x, xy_)
                .plus(at.y, yy_)
                .plus(at.xx, xxy_)
                .plus(at.xy, xyy_)
                .plus(at.yy, yyy_);
        }

    private:
        Space value_, x_, y_, xx_, xy_, yy_, xxx_, xxy_, xyy_, yyy_;
    };

    Cubic origin_, direction_;
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
