#include "tests/bench/bare_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/bare_kernels.cpp"
// First: it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then what is made for the one in hand.
#include "keiko/intersect/kernels/newton-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Existence test without proofs; otherwise as existence_test in existence_test-inl.h.
template <class D>
void bare_existence_test(D d, const RayPacket& rays, std::size_t lane,
                         const PackedSubPatch& sub_patch, ExistenceResult& result) {
    const RayPlanes<D> v(d, rays, lane, SameSubPatch{sub_patch, nullptr});
    const auto one = hn::Set(d, 1);
    const auto near_s = hn::Sub(v.depth, v.reach()), far_s = hn::Add(v.depth, v.reach());
    const auto missed = hn::Or(hn::Or(hn::Gt(hn::Abs(v.a), hn::Add(one, v.strip_u())),
                                      hn::Gt(hn::Abs(v.b), hn::Add(one, v.strip_v()))),
                               hn::Or(hn::Lt(far_s, hn::Load(d, rays.low.data() + lane)),
                                      hn::Gt(near_s, hn::Load(d, rays.high.data() + lane))));
    hn::Store(near_s, d, result.nearest.data() + lane);
    hn::Store(far_s, d, result.farthest.data() + lane);
    result.undecided |= lane_bits(d, hn::Not(missed), lane);
}

/// Newton's iteration without proofs; otherwise as solve_lanes in newton-inl.h.
template <class D>
LaneMask bare_solve_lanes(D d, const RayPacket& rays, std::size_t lane, LaneMask wanted,
                          const SameSubPatch& sub_patch, SubPatchRoots& result) {
    const RayPlanes<D> v(d, rays, lane, sub_patch);
    const auto one = hn::Set(d, 1);
    const auto clamped = [&](auto t) { return hn::Min(hn::Max(t, hn::Neg(one)), one); };
    std::uint8_t start_bits[8] = {static_cast<std::uint8_t>(wanted >> lane)};
    auto active = hn::LoadMaskBits(d, start_bits);
    auto found = hn::FirstN(d, 0);
    auto x = clamped(v.a), y = clamped(v.b), s = hn::Zero(d);
    for (int i = 0; i < most_steps && !hn::AllFalse(d, active); ++i) {
        const auto at = jet_of(d, sub_patch, x, y);
        const auto seen = [&](const auto& c, auto turn, auto place, std::size_t own) {
            return hn::NegMulAdd(place, c[3], hn::NegMulAdd(turn, c[2], c[own]));
        };
        const auto f = seen(at.value, v.p, v.a, 0), g = seen(at.value, v.q, v.b, 1);
        const auto fx = seen(at.by_x, v.p, v.a, 0), gx = seen(at.by_x, v.q, v.b, 1);
        const auto fy = seen(at.by_y, v.p, v.a, 0), gy = seen(at.by_y, v.q, v.b, 1);
        const auto scale = hn::Div(one, hn::NegMulAdd(fy, gx, hn::Mul(fx, gy)));
        const auto dx = hn::Mul(hn::NegMulAdd(gy, f, hn::Mul(fy, g)), scale);
        const auto dy = hn::Mul(hn::NegMulAdd(fx, g, hn::Mul(gx, f)), scale);
        const auto weight = hn::MulAdd(at.by_y[3], dy, hn::MulAdd(at.by_x[3], dx, at.value[3]));
        const auto height = hn::MulAdd(at.by_y[2], dy, hn::MulAdd(at.by_x[2], dx, at.value[2]));
        const auto small = hn::Set(d, 1e-7);
        const auto done = hn::And(active, hn::Lt(hn::Max(hn::Abs(dx), hn::Abs(dy)), small));
        x = hn::IfThenElse(active, clamped(hn::Add(x, dx)), x);
        y = hn::IfThenElse(active, clamped(hn::Add(y, dy)), y);
        s = hn::IfThenElse(done, hn::MulAdd(hn::Div(height, weight), v.step, v.depth), s);
        found = hn::Or(found, done);
        active = hn::AndNot(done, active);
    }
    hn::Store(x, d, result.x.data() + lane);
    hn::Store(y, d, result.y.data() + lane);
    hn::Store(s, d, result.s.data() + lane);
    return lane_bits(d, found, lane);
}

void bare_existence_test(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch,
                         ExistenceResult& result) {
    result.certain = result.material = result.single = result.undecided = 0;
    for_vectors(mask, [&](std::size_t lane) {
        bare_existence_test(Wide(), rays, lane, sub_patch, result);
    });
    result.undecided &= mask;
}

void bare_existence_test_single(const RayPacket& rays, std::size_t lane,
                                const PackedSubPatch& sub_patch, ExistenceResult& result) {
    result.certain = result.material = result.single = result.undecided = 0;
    bare_existence_test(One(), rays, lane, sub_patch, result);
}

void bare_solve(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch,
                const Component4* polynomial, SubPatchRoots& result) {
    result.found = result.failed = 0;
    for_vectors(mask, [&](std::size_t lane) {
        result.found |= bare_solve_lanes(Wide(), rays, lane, mask, {sub_patch, polynomial}, result);
    });
}

void bare_solve_single(const RayPacket& rays, std::size_t lane, const PackedSubPatch& sub_patch,
                       const Component4* polynomial, SubPatchRoots& result) {
    result.failed = 0;
    result.found =
        bare_solve_lanes(One(), rays, lane, LaneMask{1} << lane, {sub_patch, polynomial}, result);
}

bench::BareKernels bare_kernels() {
    return {bare_existence_test, bare_existence_test_single, bare_solve, bare_solve_single};
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace keiko {

HWY_EXPORT(bare_kernels);

bench::BareKernels bench::bare_kernels() {
    return HWY_DYNAMIC_DISPATCH(bare_kernels)();
}

} // namespace keiko
#endif
