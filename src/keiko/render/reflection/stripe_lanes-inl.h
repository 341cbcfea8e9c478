// Compiled once for each instruction set by lamp_kernels.cpp.
#if defined(KEIKO_RENDER_STRIPE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_RENDER_STRIPE_LANES_INL_H
#undef KEIKO_RENDER_STRIPE_LANES_INL_H
#else
#define KEIKO_RENDER_STRIPE_LANES_INL_H
#endif

#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/render/reflection/image_lanes-inl.h"
#include "keiko/render/reflection/lamp_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// PixelFilter, one a lane.
class FilterLanes {
public:
    /// Filters of two widths, of either sign.
    FilterLanes(Real by_x, Real by_y)
        : wide_(hn::Max(hn::Abs(by_x), hn::Abs(by_y))),
          narrow_(hn::Min(hn::Abs(by_x), hn::Abs(by_y))),
          reach_(hn::Mul(real(0.5), hn::Add(wide_, narrow_))),
          per_wide_(hn::Div(real(1), wide_)),
          per_both_(hn::Div(per_wide_, hn::Add(narrow_, narrow_))) {}

    /// Share of the filter between two positions relative to its centre; 0 if they are not rising.
    Real share(Real begin, Real end) const {
        const Real between = hn::Sub(below(end), below(begin));
        return hn::IfThenElseZero(hn::Lt(begin, end), between);
    }
    /// Half the extent of the filter.
    Real reach() const { return reach_; }
    /// The larger of the two widths.
    Real width() const { return wide_; }

private:
    /// Integral of the filter from its centre to x.
    Real below(Real x) const {
        const Real away = hn::Abs(x), rest = hn::Sub(reach_, away);
        const Real slope = hn::NegMulAdd(hn::Mul(rest, rest), per_both_, real(0.5));
        const Real flat = hn::Mul(away, per_wide_);
        const Real inside = hn::IfThenElse(hn::Le(away, hn::Sub(reach_, narrow_)), flat, slope);
        const Real half = hn::IfThenElse(hn::Ge(away, reach_), real(0.5), inside);
        return hn::CopySignToAbs(half, x);
    }

    Real wide_, narrow_, reach_, per_wide_, per_both_;
};

/// comb_coverage() of strips narrower than the pitch.
inline Real strips_coverage(const CPlaneFrame& frame, Truth wanted, Real half, Real center,
                            const FilterLanes& filter) {
    const Real first = real(frame.first), pitch = real(frame.pitch);
    const double last = frame.lamps - 1;
    const Real reach = hn::Add(filter.reach(), half), away = hn::Sub(center, first);
    const Real begin = hn::Max(hn::Ceil(hn::Div(hn::Sub(away, reach), pitch)), real(0));
    const Real end = hn::Min(hn::Floor(hn::Div(hn::Add(away, reach), pitch)), real(last));
    Real sum = real(0);
    for (Real lamp = begin;; lamp = hn::Add(lamp, real(1))) {
        const Truth more = hn::And(wanted, hn::Le(lamp, end));
        if (hn::AllFalse(Wide(), more)) return sum;
        const Real at = hn::Sub(hn::MulAdd(lamp, pitch, first), center);
        const Real share = filter.share(hn::Sub(at, half), hn::Add(at, half));
        sum = hn::Add(sum, hn::IfThenElseZero(more, share));
    }
}

/// Width of a filter in pitches beyond which lamps are averaged, as in c_plane_lookup.cpp.
constexpr double resolvable_pitches = 4;

/// comb_coverage() of strips `width` wide, or mean_coverage() if they are too fine.
inline Real across_coverage(const CPlaneFrame& frame, Truth wanted, Real width, Real center,
                            const FilterLanes& filter) {
    const Real pitch = real(frame.pitch), half = hn::Mul(real(0.5), width);
    const auto row = [&](Real beyond) {
        return filter.share(hn::Sub(hn::Sub(real(frame.first), beyond), center),
                            hn::Sub(hn::Add(real(frame.last()), beyond), center));
    };
    const Truth fine = hn::Gt(filter.width(), real(resolvable_pitches * frame.pitch));
    const Truth apart = hn::AndNot(fine, hn::Lt(width, pitch));
    Real sum = strips_coverage(frame, hn::And(wanted, apart), half, center, filter);
    if (hn::AllFalse(Wide(), hn::AndNot(apart, wanted))) return sum;
    sum = hn::IfThenElse(apart, sum, row(half));
    const Real mean = hn::Mul(hn::Div(width, pitch), row(real(frame.pitch / 2)));
    const Truth grey = hn::And(fine, hn::Lt(width, pitch));
    return hn::IfThenElse(grey, mean, sum);
}

/// Apparent shift of the ends of lamps along them, and width of strips.
struct LookLanes {
    Real room;  ///< mm, along the lamps
    Real width; ///< mm, across them

    /// Lamps of a row as images of rays on its plane show them.
    LookLanes(const StripeRow& row, const ImageLanes& image) {
        const CPlaneFrame& frame = row.frame;
        const VectorLanes& d = image.direction;
        room = real(0), width = real(frame.diameter);
        if (row.look != MirrorModel::tube) return;
        const Real down = hn::Abs(d.z);
        const Real flat = hn::Sqrt(hn::MulAdd(d.z, d.z, hn::Mul(d.y, d.y)));
        width = hn::Div(hn::Mul(width, flat), down);
        room = image.widened(end_room(frame, d));
    }
};

/// look_up() of some lanes, which are few; elsewhere 0.
inline Real coverage_one_by_one(const StripeRow& row, const ImageLanes& image, Truth wanted) {
    const Wide d;
    const CPlaneFrame& frame = row.frame;
    const std::array all{image.t,           image.at.x,        image.at.y,      image.direction.x,
                         image.direction.y, image.direction.z, image.u_dx,      image.v_dx,
                         image.u_dy,        image.v_dy,        image.descent_x, image.descent_y};
    std::array<std::array<double, LampCoverageBatch::capacity>, all.size()> of;
    for (std::size_t i = 0; i < all.size(); ++i) hn::StoreU(all[i], d, of[i].data());
    std::array<double, LampCoverageBatch::capacity> found{};
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        if ((lane_bits(d, wanted, 0) >> lane & 1) == 0) continue;
        const auto at = [&](std::size_t number) { return of[number][lane]; };
        const CPlaneHit hit{at(0), at(1), at(2), {at(3), at(4), at(5)}};
        const Vec3 direction = frame.u * at(3) + frame.v * at(4) + frame.normal * at(5);
        const Footprint footprint{{at(6), at(7)}, {at(8), at(9)}, {at(10), at(11)}};
        // Only points and exact models need the origin.
        found[lane] = look_up(frame, hit, Vec3(0), direction, footprint, row.look).coverage;
    }
    return hn::LoadU(d, found.data());
}

/// Images that lie between lamps or beside them, regardless of their ends. Strips widen for rays
/// nearer to the plane's horizon than the centre's; none exceeds `width` by more than that.
inline Truth is_in_gap(const CPlaneFrame& frame, const ImageLanes& image, Real width) {
    const Real pitch = real(frame.pitch), first = real(frame.first), v = image.at.y;
    const Real least = hn::Sub(real(1), half_sum(image.descent_x, image.descent_y));
    const Real half = hn::Mul(real(0.5), width);
    const Real reach = half_sum(image.v_dx, image.v_dy);
    const Real nearest = hn::Floor(hn::Add(hn::Div(hn::Sub(v, first), pitch), real(0.5)));
    const Real lamp = hn::Min(hn::Max(nearest, real(0)), real(frame.lamps - 1.0));
    const Real off = hn::Mul(least, hn::Abs(hn::Sub(v, hn::MulAdd(lamp, pitch, first))));
    const Truth between = hn::And(hn::Gt(least, real(0)), hn::Gt(off, hn::Add(half, reach)));
    return hn::And(between, hn::Lt(reach, hn::Mul(real(0.5), hn::Mul(least, pitch))));
}

/// LampCoverage::coverage, of images that are no points.
inline Real coverage(const StripeRow& row, const ImageLanes& image) {
    const CPlaneFrame& frame = row.frame;
    if (frame.lamps == 0) return real(0);
    const LookLanes look(row, image);
    const Real reach = image.reach_along();
    const Real low = hn::Sub(image.at.x, reach), high = hn::Add(image.at.x, reach);
    const Real length = real(frame.length);
    const Truth beside =
        hn::Or(hn::Le(high, hn::Neg(look.room)), hn::Ge(low, hn::Add(length, look.room)));
    const Truth reached = hn::AndNot(beside, image.meets);
    if (hn::AllFalse(Wide(), reached)) return real(0);
    const Real layer = real(row.look == MirrorModel::tube ? frame.radius() : 0);
    const Real height = hn::Abs(hn::Mul(image.t, image.direction.z));
    const Truth among = hn::And(reached, hn::Lt(height, layer)); // starts_among_tubes()
    const Truth within = hn::And(hn::Ge(low, look.room), hn::Le(high, hn::Sub(length, look.room)));
    const Truth amid = hn::AndNot(among, hn::And(reached, within));
    const FilterLanes across(image.v_dx, image.v_dy);
    const Real of_strips =
        hn::IfThenElseZero(amid, across_coverage(frame, amid, look.width, image.at.y, across));
    Truth others = hn::AndNot(amid, reached); // at ends, and among tubes
    if (hn::AllFalse(Wide(), others)) return of_strips;
    others = hn::AndNot(is_in_gap(frame, image, look.width), others);
    if (hn::AllFalse(Wide(), others)) return of_strips;
    return hn::IfThenElse(amid, of_strips, coverage_one_by_one(row, image, others));
}

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
    const VectorLanes& d = image.direction;
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

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
