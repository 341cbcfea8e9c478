// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_NEWTON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_NEWTON_INL_H
#undef KEIKO_INTERSECT_NEWTON_INL_H
#else
#define KEIKO_INTERSECT_NEWTON_INL_H
#endif

#include "keiko/intersect/kernels/existence_test-inl.h"
#include "keiko/intersect/kernels/sub_patch_jet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Newton needs three steps from the plane; what takes more is in trouble.
constexpr int most_steps = 8;
/// Largest bound of a root's place, in half sub-patches; beyond it clipping has to decide.
constexpr double widest_root = 1e-3;

/// Largest error that Newton's remainder may add to a root, in the frame's unit: rounding is
/// usually far smaller than its bound, and one more step costs little.
template <class D>
hn::Vec<D> far_below(D d, hn::Vec<D> noise) {
    return hn::MulAdd(hn::Set(d, 1e-3), noise, hn::Set(d, 2e-14));
}

/// Newton's method on F = w X - p w Z - a w and G likewise, clamped to the sub-patch. With c the
/// contraction, a root on the sub-patch is within r = |F| / (1 - c) of the place z, and within 2.
/// Let J be the Jacobian at z, m a bound of its inverse, K the bend and s = |J^-1 F(z)| the step.
/// The root is then within m K r^2 / 2 of where the step leads. Hence r <= s + m K r^2 / 2. Where m
/// K r < 1 that leaves the smaller solution, r <= s (1 + 2 h) with h = m K s <= 1/2
/// [Kantorovich1948]. No root is on the sub-patch when the step leads farther from it than the
/// bound.
template <class D, class SubPatches>
class Newton {
    using V = hn::Vec<D>;

public:
    /// Search for the rays of a vector that begins at `lane`; `wanted` are lanes of the packet. It
    /// starts where the rays meet the frame's plane.
    Newton(const RayPacket& rays, std::size_t lane, LaneMask wanted, const SubPatches& sub_patches)
        : sub_patches_(sub_patches), lane_(lane), v_(d_, rays, lane, sub_patches) {
        std::uint8_t bits[8] = {static_cast<std::uint8_t>(wanted >> lane)};
        active_ = hn::LoadMaskBits(d_, bits);
        x_ = clamped(v_.a), y_ = clamped(v_.b);
        regain_ = hn::Div(one(), hn::Sub(one(), v_.contraction));
        noise_ = hn::Mul(hn::Max(v_.blur_u, v_.blur_v), regain_);
    }

    /// True if any lane is undecided.
    bool working() const { return !hn::AllFalse(d_, active_); }

    /// One step for every undecided lane.
    void step() {
        const Jet<V> at = jet_of(d_, sub_patches_, active_, x_, y_);
        const auto seen = [&](const std::array<V, 4>& c, V turn, V place, std::size_t own) {
            return hn::NegMulAdd(place, c[3], hn::NegMulAdd(turn, c[2], c[own]));
        };
        const V f = seen(at.value, v_.p, v_.a, 0), g = seen(at.value, v_.q, v_.b, 1);
        const V fx = seen(at.by_x, v_.p, v_.a, 0), gx = seen(at.by_x, v_.q, v_.b, 1);
        const V fy = seen(at.by_y, v_.p, v_.a, 0), gy = seen(at.by_y, v_.q, v_.b, 1);
        const V scale = hn::Div(one(), hn::NegMulAdd(fy, gx, hn::Mul(fx, gy)));
        const V dx = hn::Mul(hn::NegMulAdd(gy, f, hn::Mul(fy, g)), scale);
        const V dy = hn::Mul(hn::NegMulAdd(fx, g, hn::Mul(gx, f)), scale);
        const auto sum = [](V first, V second) { return hn::Add(hn::Abs(first), hn::Abs(second)); };
        const V inverse = hn::Mul(hn::Abs(scale), hn::Max(sum(gy, fy), sum(gx, fx)));
        const V residual = hn::Max(hn::Abs(f), hn::Abs(g));
        const V way = hn::Add(hn::Max(hn::Abs(dx), hn::Abs(dy)), noise_);
        advance(at, dx, dy, rest(inverse, residual, way));
    }

    /// Returns the lanes that have a root.
    LaneMask write(SubPatchRoots& result) const {
        hn::Store(x_, d_, result.x.data() + lane_);
        hn::Store(y_, d_, result.y.data() + lane_);
        hn::Store(error_, d_, result.error.data() + lane_);
        hn::Store(s_, d_, result.s.data() + lane_);
        result.failed |= lane_bits(d_, active_, lane_);
        return lane_bits(d_, found_, lane_);
    }

private:
    /// Bound of the distance to the root that a step leaves.
    struct Rest {
        V remainder; ///< of Taylor's formula
        V bound;     ///< with the rounding
    };

    static V one() { return hn::Set(d_, 1); }
    static V clamped(V t) { return hn::Min(hn::Max(t, hn::Neg(one())), one()); }

    /// `inverse`: bound of the inverse of J; `residual`: of F; `way`: of the step.
    Rest rest(V inverse, V residual, V way) const {
        const V two = hn::Set(d_, 2), half = hn::Set(d_, 0.5);
        const V bend = hn::Mul(inverse, v_.bend());
        const V far = hn::Min(hn::MulAdd(residual, regain_, noise_), two);
        const V h = hn::Mul(bend, way);
        const V near = hn::MulAdd(hn::Mul(two, h), way, way);
        const auto smaller = hn::And(hn::Lt(hn::Mul(bend, far), one()), hn::Le(h, half));
        const V off = hn::IfThenElse(smaller, hn::Min(far, near), far);
        const V remainder = hn::Mul(hn::Mul(half, bend), hn::Mul(off, off));
        // The Jacobian is rounded, too: by the noise, times the degrees, over the way to the root.
        const V turned = hn::Mul(noise_, sub_patches_.degrees(d_));
        return {remainder, hn::Add(remainder, hn::MulAdd(turned, off, noise_))};
    }

    /// Distance along the ray of the place that a step leads to.
    V distance(const Jet<V>& at, V dx, V dy) const {
        V height = hn::MulAdd(at.by_y[2], dy, hn::MulAdd(at.by_x[2], dx, at.value[2]));
        if (sub_patches_.rational())
            height = hn::Div(height,
                             hn::MulAdd(at.by_y[3], dy, hn::MulAdd(at.by_x[3], dx, at.value[3])));
        return hn::MulAdd(height, v_.step, v_.depth);
    }

    void advance(const Jet<V>& at, V dx, V dy, const Rest& rest) {
        const V limit = hn::Add(one(), rest.bound);
        const V next_x = hn::Add(x_, dx), next_y = hn::Add(y_, dy);
        const auto inside = hn::And(hn::Le(hn::Abs(next_x), limit), hn::Le(hn::Abs(next_y), limit));
        const auto outside = hn::Or(hn::Gt(hn::Abs(next_x), limit), hn::Gt(hn::Abs(next_y), limit));
        const auto settled = hn::And(hn::Le(rest.remainder, far_below(d_, noise_)),
                                     hn::Lt(rest.bound, hn::Set(d_, widest_root)));
        const auto done = hn::And(hn::And(active_, inside), settled);
        x_ = hn::IfThenElse(active_, clamped(next_x), x_);
        y_ = hn::IfThenElse(active_, clamped(next_y), y_);
        error_ = hn::IfThenElse(done, rest.bound, error_);
        s_ = hn::IfThenElse(done, distance(at, dx, dy), s_);
        found_ = hn::Or(found_, done);
        active_ = hn::AndNot(hn::Or(done, outside), active_);
    }

    static constexpr D d_{};
    SubPatches sub_patches_;
    std::size_t lane_;
    RayPlanes<D> v_;
    V regain_, noise_, x_, y_, error_ = hn::Zero(d_), s_ = hn::Zero(d_);
    hn::Mask<D> active_, found_ = hn::FirstN(d_, 0);
};

/// Lets some vectors of rays step in turns, so that none waits for its own last step alone.
template <class... Vectors>
LaneMask solve_in_turns(SubPatchRoots& result, Vectors&... vectors) {
    for (int i = 0; i < most_steps && (vectors.working() || ...); ++i)
        ((vectors.working() ? vectors.step() : void()), ...);
    return (vectors.write(result) | ...);
}

/// For the lanes of a mask, two vectors at a time; `sub_patches_at(lane)` are those of the vector
/// that begins there.
template <class SubPatchesAt>
void solve_lanes(const RayPacket& rays, LaneMask mask, const SubPatchesAt& sub_patches_at,
                 SubPatchRoots& result) {
    using Lanes = Newton<Wide, decltype(sub_patches_at(0))>;
    result.found = result.failed = 0;
    constexpr std::size_t none = RayPacket::capacity;
    std::size_t first = none;
    for_vectors(mask, [&](std::size_t lane) {
        if (first == none) {
            first = lane;
            return;
        }
        Lanes a(rays, first, mask, sub_patches_at(first)),
            b(rays, lane, mask, sub_patches_at(lane));
        result.found |= solve_in_turns(result, a, b);
        first = none;
    });
    if (first == none) return;
    Lanes last(rays, first, mask, sub_patches_at(first));
    result.found |= solve_in_turns(result, last);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
