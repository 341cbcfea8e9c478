#include "keiko/render/reflection/lamp_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/render/reflection/lamp_kernels.cpp"
// First, as it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then the code for the current one.
#include "keiko/render/reflection/pixel_lanes-inl.h"
#include "keiko/render/reflection/stripe_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

void look_at_vector(const StripeRow& row, const ReflectedRays& rays, std::size_t place,
                    std::size_t width, bool thorough, std::size_t lane, LampCoverageBatch& looks) {
    const Wide d;
    const PixelLanes pixel(rays, place + lane, width);
    const FrameLanes frame(row.frame);
    const ImageLanes image(frame, pixel.centre);
    const auto store = [&](Real from, LampCoverageBatch::Lanes<double>& to) {
        hn::Store(from, d, to.data() + lane);
    };
    const Truth missed = misses_lamps(row.frame, pixel, image);
    looks.missed |= lane_bits(d, missed, lane);
    looks.meets |= lane_bits(d, image.meets, lane);
    if (hn::AllFalse(d, image.meets)) return;
    store(image.t, looks.t), store(image.at.x, looks.u), store(image.at.y, looks.v);
    if (thorough) store(residual(pixel, image.t), looks.residual);
    const bool dark = hn::AllFalse(d, hn::AndNot(missed, image.meets));
    if (dark && !thorough) return;
    const BendLanes bend(row.frame, frame, pixel, image);
    store(bend.bend, looks.bend);
    looks.bounded |= lane_bits(d, bend.bounded, lane);
    looks.points |= lane_bits(d, image.is_point(), lane);
    if (!dark) store(coverage(row, image), looks.coverage);
}

void look(const StripeRow& row, const ReflectedRays& rays, std::size_t place, std::size_t width,
          bool thorough, LampCoverageBatch& looks) {
    looks.meets = looks.missed = looks.bounded = looks.points = 0;
    for (std::size_t lane = 0; lane < LampCoverageBatch::capacity; lane += hn::Lanes(Wide()))
        look_at_vector(row, rays, place, width, thorough, lane, looks);
}

double coverage_of_parts(const StripeRow& row, const ReflectedRays& rays, std::size_t place,
                         std::size_t width, const SquareParts& parts) {
    const Wide d;
    const FrameLanes frame(row.frame);
    const CubicLanes cubic(rays, place, width);
    const double side = parts.side, count = side * side;
    std::array<double, LampCoverageBatch::capacity> sums{};
    const auto at = [&](Real number) {
        return hn::Sub(hn::Mul(hn::Add(number, real(0.5)), real(1 / side)), real(0.5));
    };
    for (double first = 0; first < count; first += static_cast<double>(hn::Lanes(d))) {
        const Real number = hn::Add(real(first), hn::Iota(d, 0));
        const Real line = hn::Floor(hn::Mul(hn::Add(number, real(0.5)), real(1 / side)));
        const Real column = hn::NegMulAdd(line, real(side), number);
        const ImageLanes image(frame, cubic.part(at(column), at(line), 1 / side));
        const Truth seen = hn::And(hn::Lt(number, real(count)), hn::Le(image.t, real(parts.t_max)));
        hn::StoreU(
            hn::Add(hn::LoadU(d, sums.data()), hn::IfThenElseZero(seen, coverage(row, image))), d,
            sums.data());
    }
    double sum = 0;
    for (const double s : sums) sum += s;
    return sum / count;
}

LampKernels make_stripe_kernels() {
    return {hwy::TargetName(HWY_TARGET), look, coverage_of_parts};
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace keiko {

HWY_EXPORT(make_stripe_kernels);

LampKernels lamp_kernels() {
    return HWY_DYNAMIC_DISPATCH(make_stripe_kernels)();
}

} // namespace keiko
#endif
