// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_NEWTON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_NEWTON_INL_H
#undef KEIKO_TRACE_NEWTON_INL_H
#else
#define KEIKO_TRACE_NEWTON_INL_H
#endif

#include "keiko/trace/leaf_jet-inl.h"
#include "keiko/trace/leaf_view-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Newton needs three steps from the plane; what takes more is in trouble.
constexpr int most_steps = 8;
/// Of half a leaf: a bound beyond this is no place; clipping has to tell what is there.
constexpr double widest_root = 1e-3;

inline double degrees_of(const HotLeaf& leaf) {
    return static_cast<double>(leaf.degree_u) + static_cast<double>(leaf.degree_v);
}

/// What Newton's remainder may add to a root, in the frame's unit: rounding is usually far smaller
/// than its bound, and one more step costs little.
template <class D>
hn::Vec<D> far_below(D d, hn::Vec<D> noise) {
    return hn::MulAdd(hn::Set(d, 1e-3), noise, hn::Set(d, 2e-14));
}

/// Newton's method on F = w X - p w Z - a w and G likewise, clamped to the leaf. With c the
/// contraction, a root on the leaf is within r = |F| / (1 - c) of the place z, and within 2; with J
/// the Jacobian at z, m a bound of its inverse, K the bend and s = |J^-1 F(z)| the step, within
/// m K r^2 / 2 of where the step leads. Hence r <= s + m K r^2 / 2, and where m K r < 1 that leaves
/// the smaller solution, r <= s (1 + 2 h) with h = m K s <= 1/2 (Kantorovich). No root is on the
/// leaf when the step leads farther off it than the bound.
template <class D, class Leaves>
LaneMask solve_lanes(D d, const RayBlock& rays, std::size_t lane, LaneMask wanted,
                     const Leaves& leaves, LeafRoots& result) {
    const View<D> v(d, rays, lane, leaves);
    const auto one = hn::Set(d, 1), zero = hn::Zero(d);
    const auto clamped = [&](auto t) { return hn::Min(hn::Max(t, hn::Neg(one)), one); };
    const auto regain = hn::Div(one, hn::Sub(one, v.contraction));
    const auto noise = hn::Mul(hn::Max(v.blur_u, v.blur_v), regain);
    const auto enough = far_below(d, noise);
    const auto two = hn::Set(d, 2), half = hn::Set(d, 0.5), widest = hn::Set(d, widest_root);
    const auto degrees = hn::Set(d, degrees_of(leaves.shape()));
    std::uint8_t start_bits[8] = {static_cast<std::uint8_t>(wanted >> lane)};
    auto active = hn::LoadMaskBits(d, start_bits);
    auto found = hn::FirstN(d, 0);
    auto x = clamped(v.a), y = clamped(v.b);
    auto error = zero, s = zero;
    for (int i = 0; i < most_steps && !hn::AllFalse(d, active); ++i) {
        const auto at = jet_of(d, leaves, x, y);
        const auto seen = [&](const auto& c, auto turn, auto place, std::size_t own) {
            return hn::NegMulAdd(place, c[3], hn::NegMulAdd(turn, c[2], c[own]));
        };
        const auto f = seen(at.value, v.p, v.a, 0), g = seen(at.value, v.q, v.b, 1);
        const auto fx = seen(at.by_x, v.p, v.a, 0), gx = seen(at.by_x, v.q, v.b, 1);
        const auto fy = seen(at.by_y, v.p, v.a, 0), gy = seen(at.by_y, v.q, v.b, 1);
        const auto scale = hn::Div(one, hn::NegMulAdd(fy, gx, hn::Mul(fx, gy)));
        const auto dx = hn::Mul(hn::NegMulAdd(gy, f, hn::Mul(fy, g)), scale);
        const auto dy = hn::Mul(hn::NegMulAdd(fx, g, hn::Mul(gx, f)), scale);
        const auto sum = [](auto first, auto second) {
            return hn::Add(hn::Abs(first), hn::Abs(second));
        };
        const auto inverse = hn::Mul(hn::Abs(scale), hn::Max(sum(gy, fy), sum(gx, fx)));
        const auto bend = hn::Mul(inverse, v.bend());
        const auto far = hn::Min(hn::MulAdd(hn::Max(hn::Abs(f), hn::Abs(g)), regain, noise), two);
        const auto step = hn::Add(hn::Max(hn::Abs(dx), hn::Abs(dy)), noise);
        const auto h = hn::Mul(bend, step);
        const auto near = hn::MulAdd(hn::Mul(two, h), step, step);
        const auto smaller = hn::And(hn::Lt(hn::Mul(bend, far), one), hn::Le(h, half));
        const auto off = hn::IfThenElse(smaller, hn::Min(far, near), far);
        const auto remainder = hn::Mul(hn::Mul(half, bend), hn::Mul(off, off));
        // The Jacobian is rounded, too: by the noise, times the degrees, over the way to the root.
        const auto bound = hn::Add(remainder, hn::MulAdd(hn::Mul(noise, degrees), off, noise));
        const auto limit = hn::Add(one, bound);
        const auto next_x = hn::Add(x, dx), next_y = hn::Add(y, dy);
        const auto inside = hn::And(hn::Le(hn::Abs(next_x), limit), hn::Le(hn::Abs(next_y), limit));
        const auto settled = hn::And(hn::Le(remainder, enough), hn::Lt(bound, widest));
        const auto done = hn::And(hn::And(active, inside), settled);
        const auto outside = hn::Or(hn::Gt(hn::Abs(next_x), limit), hn::Gt(hn::Abs(next_y), limit));

        const auto weight = hn::MulAdd(at.by_y[3], dy, hn::MulAdd(at.by_x[3], dx, at.value[3]));
        const auto height = hn::MulAdd(at.by_y[2], dy, hn::MulAdd(at.by_x[2], dx, at.value[2]));
        const auto here = hn::MulAdd(hn::Div(height, weight), v.step, v.depth);
        x = hn::IfThenElse(active, clamped(next_x), x);
        y = hn::IfThenElse(active, clamped(next_y), y);
        error = hn::IfThenElse(done, bound, error);
        s = hn::IfThenElse(done, here, s);
        found = hn::Or(found, done);
        active = hn::AndNot(hn::Or(done, outside), active);
    }
    hn::Store(x, d, result.x.data() + lane);
    hn::Store(y, d, result.y.data() + lane);
    hn::Store(error, d, result.error.data() + lane);
    hn::Store(s, d, result.s.data() + lane);
    const auto bits = [&](hn::Mask<D> mask) { return lane_bits(d, mask, lane); };
    result.failed |= bits(active);
    return bits(found);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
