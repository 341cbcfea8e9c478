#include "keiko/trace/leaf_kernels.h"

#include "keiko/trace/ray_blur.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/trace/leaf_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Every multiply-add below is MulAdd, fused on some targets only: the bounds hold both ways, since
// fusing only ever leaves a rounding out. Wide and single forms do the same steps in the same
// order, so that a ray gets the same bits in any company.

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A leaf as a ray sees it: the ray meets the plane of the frame at (a, b), moving by (p, q)
/// for each unit of height.
template <class D>
struct View {
    using V = hn::Vec<D>;

    V a, b, p, q;
    V depth;          ///< mm along the ray to the plane
    V step;           ///< mm along the ray for a unit of height
    V steep;          ///< |step| times the length of the height's row: 1 / cosine
    V blur_u, blur_v; ///< of a and b, with all that the leaf's own blur adds
    V contraction;    ///< of LeafFrame, for this ray

    View(D d, const RayBlock& rays, std::size_t lane, const HotLeaf& leaf) {
        const auto load = [&](const RayBlock::Lanes<double>& from) {
            return hn::Load(d, from.data() + lane);
        };
        const auto set = [&](double x) { return hn::Set(d, x); };
        const V o0 = hn::Sub(load(rays.start[0]), set(leaf.center[0]));
        const V o1 = hn::Sub(load(rays.start[1]), set(leaf.center[1]));
        const V o2 = hn::Sub(load(rays.start[2]), set(leaf.center[2]));
        const V d0 = load(rays.direction[0]), d1 = load(rays.direction[1]);
        const V d2 = load(rays.direction[2]);
        const auto row = [&](const std::array<double, 3>& r, V x, V y, V z) {
            return hn::MulAdd(set(r[2]), z, hn::MulAdd(set(r[1]), y, hn::Mul(set(r[0]), x)));
        };
        step = hn::Div(set(1), row(leaf.rows[2], d0, d1, d2));
        const V height = row(leaf.rows[2], o0, o1, o2);
        p = hn::Mul(row(leaf.rows[0], d0, d1, d2), step);
        q = hn::Mul(row(leaf.rows[1], d0, d1, d2), step);
        a = hn::NegMulAdd(height, p, row(leaf.rows[0], o0, o1, o2));
        b = hn::NegMulAdd(height, q, row(leaf.rows[1], o0, o1, o2));
        depth = hn::Neg(hn::Mul(height, step));
        steep = hn::Mul(hn::Abs(step), set(leaf.row_length[2]));

        const V pp = hn::Abs(p), qq = hn::Abs(q);
        const V blur =
            hn::MulAdd(set(ray_rounding), hn::Abs(depth), hn::Add(load(rays.blur), set(leaf.blur)));
        blur_u = hn::Mul(blur, hn::MulAdd(pp, set(leaf.row_length[2]), set(leaf.row_length[0])));
        blur_v = hn::Mul(blur, hn::MulAdd(qq, set(leaf.row_length[2]), set(leaf.row_length[1])));
        blur_s_ = hn::Mul(blur, steep);
        const auto mixed = [&](const std::array<double, 4>& e, std::size_t own, V turn, V at) {
            return hn::MulAdd(hn::Abs(at), set(e[3]), hn::MulAdd(turn, set(e[2]), set(e[own])));
        };
        contraction = hn::Max(mixed(leaf.slope, 0, pp, a), mixed(leaf.slope, 1, qq, b));
        strip_u_ = hn::Add(mixed(leaf.value, 0, pp, a), blur_u);
        strip_v_ = hn::Add(mixed(leaf.value, 1, qq, b), blur_v);
        bend_ = hn::Max(mixed(leaf.bend, 0, pp, a), mixed(leaf.bend, 1, qq, b));
        reach_ = hn::MulAdd(hn::Abs(step), set(leaf.height), blur_s_);
    }

    /// Half widths of the strips around (a, b) that a root lies in, and of the range of s.
    V strip_u() const { return strip_u_; }
    V strip_v() const { return strip_v_; }
    V reach() const { return reach_; }
    V bend() const { return bend_; }

private:
    V strip_u_, strip_v_, bend_, reach_, blur_s_;
};

/// Beyond this the proofs' own rounding would matter.
constexpr double largest_contraction = 0.95;
/// 1 / cosine: rays lower over the leaf see a plane that is mostly rounding.
constexpr double steepest = 1e6;

template <class D>
void look_at(D d, const RayBlock& rays, std::size_t lane, const HotLeaf& leaf, LeafLook& result) {
    const View<D> v(d, rays, lane, leaf);
    const auto one = hn::Set(d, 1);
    const auto near_s = hn::Sub(v.depth, v.reach()), far_s = hn::Add(v.depth, v.reach());
    const auto low = hn::Load(d, rays.low.data() + lane);
    const auto high = hn::Load(d, rays.high.data() + lane);
    const auto a = hn::Abs(v.a), b = hn::Abs(v.b);
    const auto sane = hn::Lt(v.steep, hn::Set(d, steepest));
    const auto missed =
        hn::Or(hn::Or(hn::Gt(a, hn::Add(one, v.strip_u())), hn::Gt(b, hn::Add(one, v.strip_v()))),
               hn::Or(hn::Lt(far_s, low), hn::Gt(near_s, high)));
    const auto left = hn::Not(hn::And(sane, missed));
    const auto single =
        hn::And(hn::And(left, sane), hn::Lt(v.contraction, hn::Set(d, largest_contraction)));
    const auto within = [&](auto place, auto strip, std::size_t axis) {
        return hn::And(hn::Ge(hn::Sub(place, strip), hn::Set(d, leaf.patch_low[axis])),
                       hn::Le(hn::Add(place, strip), hn::Set(d, leaf.patch_high[axis])));
    };
    const auto inside = hn::And(within(v.a, v.strip_u(), 0), within(v.b, v.strip_v(), 1));
    hn::Store(near_s, d, result.nearest.data() + lane);
    hn::Store(far_s, d, result.farthest.data() + lane);
    const auto bits = [&](auto mask) {
        std::uint8_t b8[8] = {};
        hn::StoreMaskBits(d, mask, b8);
        return static_cast<LaneMask>(b8[0]) << lane;
    };
    result.certain |= bits(hn::And(single, inside));
    result.single |= bits(hn::AndNot(inside, single));
    result.undecided |= bits(hn::AndNot(single, left));
}

/// Value and first derivatives of the components at (x, y).
template <class V>
struct Jet {
    std::array<V, 4> value, by_x, by_y;
};

template <class D, bool rational>
Jet<hn::Vec<D>> jet(D d, const HotLeaf& leaf, const Component4* polynomial, hn::Vec<D> x,
                    hn::Vec<D> y) {
    using V = hn::Vec<D>;
    constexpr std::size_t used = rational ? 4 : 3;
    const std::size_t columns = leaf.degree_v + 1u;
    Jet<V> jet;
    for (std::size_t i = leaf.degree_u + 1u; i-- > 0;) {
        const Component4* row = polynomial + i * columns;
        std::array<V, used> value, slope;
        for (std::size_t c = 0; c < used; ++c) {
            value[c] = hn::Set(d, row[columns - 1][c]);
            slope[c] = hn::Zero(d);
        }
        for (std::size_t j = columns - 1; j-- > 0;)
            for (std::size_t c = 0; c < used; ++c) {
                slope[c] = hn::MulAdd(slope[c], y, value[c]);
                value[c] = hn::MulAdd(value[c], y, hn::Set(d, row[j][c]));
            }
        for (std::size_t c = 0; c < used; ++c) {
            if (i == leaf.degree_u) {
                jet.by_x[c] = hn::Zero(d);
                jet.value[c] = value[c];
                jet.by_y[c] = slope[c];
            } else {
                jet.by_x[c] = hn::MulAdd(jet.by_x[c], x, jet.value[c]);
                jet.value[c] = hn::MulAdd(jet.value[c], x, value[c]);
                jet.by_y[c] = hn::MulAdd(jet.by_y[c], x, slope[c]);
            }
        }
    }
    return jet;
}

/// The same for one ray, the components side by side.
struct SingleJet {
    alignas(32) std::array<double, 4> value, by_x, by_y;
};

SingleJet single_jet(const HotLeaf& leaf, const Component4* polynomial, double at_x, double at_y) {
    const hn::CappedTag<double, 4> d;
    const std::size_t columns = leaf.degree_v + 1u;
    const auto x = hn::Set(d, at_x), y = hn::Set(d, at_y);
    SingleJet jet;
    for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
        auto total = hn::Zero(d), by_x = hn::Zero(d), by_y = hn::Zero(d);
        for (std::size_t i = leaf.degree_u + 1u; i-- > 0;) {
            const Component4* row = polynomial + i * columns;
            auto value = hn::LoadU(d, row[columns - 1].data() + c), slope = hn::Zero(d);
            for (std::size_t j = columns - 1; j-- > 0;) {
                slope = hn::MulAdd(slope, y, value);
                value = hn::MulAdd(value, y, hn::LoadU(d, row[j].data() + c));
            }
            by_x = hn::MulAdd(by_x, x, total);
            total = hn::MulAdd(total, x, value);
            by_y = hn::MulAdd(by_y, x, slope);
        }
        hn::Store(total, d, jet.value.data() + c);
        hn::Store(by_x, d, jet.by_x.data() + c);
        hn::Store(by_y, d, jet.by_y.data() + c);
    }
    return jet;
}

/// Jets of many lanes, all on one leaf.
template <class D>
Jet<hn::Vec<D>> jet_of(D d, const HotLeaf& leaf, const Component4* polynomial, hn::Vec<D> x,
                       hn::Vec<D> y) {
    using V = hn::Vec<D>;
    Jet<V> result;
    if constexpr (hn::MaxLanes(D()) == 1) {
        const SingleJet one = single_jet(leaf, polynomial, hn::GetLane(x), hn::GetLane(y));
        for (std::size_t c = 0; c < 4; ++c) {
            result.value[c] = hn::Set(d, one.value[c]);
            result.by_x[c] = hn::Set(d, one.by_x[c]);
            result.by_y[c] = hn::Set(d, one.by_y[c]);
        }
        return result;
    }
    if (leaf.rational) return jet<D, true>(d, leaf, polynomial, x, y);
    result = jet<D, false>(d, leaf, polynomial, x, y);
    result.value[3] = hn::Set(d, 1);
    result.by_x[3] = result.by_y[3] = hn::Zero(d);
    return result;
}

/// Newton needs three steps from the plane; what takes more is in trouble.
constexpr int most_steps = 8;
/// What Newton's remainder may add to a root, in the frame's unit: rounding is usually far smaller
/// than its bound, and one more step costs little.
template <class D>
hn::Vec<D> far_below(D d, hn::Vec<D> noise) {
    return hn::MulAdd(hn::Set(d, 1e-3), noise, hn::Set(d, 2e-14));
}

/// Newton's method on F = w X - p w Z - a w and G likewise, clamped to the leaf. With c the
/// contraction, the root is within |F| / (1 - c) of the place; a step leaves at most half the
/// bend times the square of that, over 1 - c. A place that far outside the leaf has no root.
template <class D>
LaneMask solve_lanes(D d, const RayBlock& rays, std::size_t lane, LaneMask wanted,
                     const HotLeaf& leaf, const Component4* polynomial, LeafRoots& result) {
    const View<D> v(d, rays, lane, leaf);
    const auto one = hn::Set(d, 1), zero = hn::Zero(d);
    const auto clamped = [&](auto t) { return hn::Min(hn::Max(t, hn::Neg(one)), one); };
    const auto regain = hn::Div(one, hn::Sub(one, v.contraction));
    const auto noise = hn::Mul(hn::Max(v.blur_u, v.blur_v), regain);
    const auto enough = far_below(d, noise);
    const auto half_bend = hn::Mul(hn::Mul(hn::Set(d, 0.5), v.bend()), regain);
    std::uint8_t start_bits[8] = {static_cast<std::uint8_t>(wanted >> lane)};
    auto active = hn::LoadMaskBits(d, start_bits);
    auto found = hn::FirstN(d, 0);
    auto x = clamped(v.a), y = clamped(v.b);
    auto error = zero, s = zero;
    for (int i = 0; i < most_steps && !hn::AllFalse(d, active); ++i) {
        const auto at = jet_of(d, leaf, polynomial, x, y);
        const auto seen = [&](const auto& c, auto turn, auto place, std::size_t own) {
            return hn::NegMulAdd(place, c[3], hn::NegMulAdd(turn, c[2], c[own]));
        };
        const auto f = seen(at.value, v.p, v.a, 0), g = seen(at.value, v.q, v.b, 1);
        const auto fx = seen(at.by_x, v.p, v.a, 0), gx = seen(at.by_x, v.q, v.b, 1);
        const auto fy = seen(at.by_y, v.p, v.a, 0), gy = seen(at.by_y, v.q, v.b, 1);
        const auto scale = hn::Div(one, hn::NegMulAdd(fy, gx, hn::Mul(fx, gy)));
        const auto dx = hn::Mul(hn::NegMulAdd(gy, f, hn::Mul(fy, g)), scale);
        const auto dy = hn::Mul(hn::NegMulAdd(fx, g, hn::Mul(gx, f)), scale);
        const auto off = hn::MulAdd(hn::Max(hn::Abs(f), hn::Abs(g)), regain, noise);
        const auto remainder = hn::Mul(half_bend, hn::Mul(off, off));
        const auto bound = hn::Add(remainder, noise);
        const auto limit = hn::Add(one, bound);
        const auto next_x = hn::Add(x, dx), next_y = hn::Add(y, dy);
        const auto inside = hn::And(hn::Le(hn::Abs(next_x), limit), hn::Le(hn::Abs(next_y), limit));
        const auto done = hn::And(hn::And(active, inside), hn::Le(remainder, enough));
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
    const auto bits = [&](auto mask) {
        std::uint8_t b8[8] = {};
        hn::StoreMaskBits(d, mask, b8);
        return static_cast<LaneMask>(b8[0]) << lane;
    };
    result.failed |= bits(active);
    return bits(found);
}

/// What one step makes of a vector of boxes.
struct NarrowedBoxes {
    alignas(64) std::array<double, 8> x, y, half_x, half_y;
    std::uint8_t left = 0, single = 0, root = 0, poor = 0;
};

/// Krawczyk's method: in a box around z of half size r, with J the Jacobian at z, every root is
/// within J^-1 (K r^2 / 2 + noise) of Newton's z - J^-1 F(z); where |J^-1| K r is below 1 there is
/// at most one.
template <class D>
void narrow_lanes(D d, const PlanePair& planes, const HotLeaf& leaf, const Component4* polynomial,
                  NarrowedBoxes& b, std::size_t lane) {
    using V = hn::Vec<D>;
    const V x = hn::Load(d, b.x.data() + lane), y = hn::Load(d, b.y.data() + lane);
    const V rx = hn::Load(d, b.half_x.data() + lane), ry = hn::Load(d, b.half_y.data() + lane);
    const Jet<V> at = jet_of(d, leaf, polynomial, x, y);
    const auto seen = [&](const std::array<V, 4>& c, std::size_t plane) {
        const Component4& w = planes.weights[plane];
        return hn::MulAdd(
            hn::Set(d, w[3]), c[3],
            hn::MulAdd(hn::Set(d, w[2]), c[2],
                       hn::MulAdd(hn::Set(d, w[1]), c[1], hn::Mul(hn::Set(d, w[0]), c[0]))));
    };
    const V f = seen(at.value, 0), g = seen(at.value, 1);
    const V fx = seen(at.by_x, 0), gx = seen(at.by_x, 1);
    const V fy = seen(at.by_y, 0), gy = seen(at.by_y, 1);
    const V r = hn::Max(rx, ry), half_square = hn::Mul(hn::Mul(hn::Set(d, 0.5), r), r);
    const auto rest = [&](std::size_t plane) {
        return hn::MulAdd(hn::Set(d, planes.bend[plane]), half_square,
                          hn::Set(d, planes.noise[plane]));
    };
    const V rest_f = rest(0), rest_g = rest(1);
    const auto clear = [&](V value, V by_x, V by_y, V remainder) {
        return hn::Gt(hn::Abs(value),
                      hn::MulAdd(hn::Abs(by_x), rx, hn::MulAdd(hn::Abs(by_y), ry, remainder)));
    };
    const V one = hn::Set(d, 1);
    const V scale = hn::Div(one, hn::NegMulAdd(fy, gx, hn::Mul(fx, gy)));
    const V size = hn::Abs(scale);
    const V dx = hn::Mul(hn::NegMulAdd(gy, f, hn::Mul(fy, g)), scale);
    const V dy = hn::Mul(hn::NegMulAdd(fx, g, hn::Mul(gx, f)), scale);
    const auto spread = [&](V along_g, V along_f, V first, V second) {
        return hn::Mul(size,
                       hn::MulAdd(hn::Abs(along_g), first, hn::Mul(hn::Abs(along_f), second)));
    };
    const V rest_x = spread(gy, fy, rest_f, rest_g), rest_y = spread(gx, fx, rest_f, rest_g);
    const V bend_f = hn::Mul(hn::Set(d, planes.bend[0]), r);
    const V bend_g = hn::Mul(hn::Set(d, planes.bend[1]), r);
    const V contraction = hn::Max(spread(gy, fy, bend_f, bend_g), spread(gx, fx, bend_f, bend_g));
    const V noise_f = hn::Set(d, planes.noise[0]), noise_g = hn::Set(d, planes.noise[1]);
    const V noise = hn::Max(spread(gy, fy, noise_f, noise_g), spread(gx, fx, noise_f, noise_g));

    const auto single = hn::Lt(contraction, hn::Set(d, largest_contraction));
    const V low_x = hn::Max(hn::Sub(x, rx), hn::Sub(hn::Add(x, dx), rest_x));
    const V high_x = hn::Min(hn::Add(x, rx), hn::Add(hn::Add(x, dx), rest_x));
    const V low_y = hn::Max(hn::Sub(y, ry), hn::Sub(hn::Add(y, dy), rest_y));
    const V high_y = hn::Min(hn::Add(y, ry), hn::Add(hn::Add(y, dy), rest_y));
    const auto empty = hn::Or(hn::Or(hn::Gt(low_x, high_x), hn::Gt(low_y, high_y)),
                              hn::Or(clear(f, fx, fy, rest_f), clear(g, gx, gy, rest_g)));
    const V half = hn::Set(d, 0.5);
    // Where J is singular Newton says nothing: the box stays as it was.
    const auto sane = hn::And(hn::Le(low_x, high_x), hn::Le(low_y, high_y));
    const V new_rx = hn::IfThenElse(sane, hn::Mul(half, hn::Sub(high_x, low_x)), rx);
    const V new_ry = hn::IfThenElse(sane, hn::Mul(half, hn::Sub(high_y, low_y)), ry);
    const auto close = hn::Le(hn::Mul(contraction, r), far_below(d, noise));
    const auto poor = hn::And(hn::Gt(new_rx, hn::Mul(hn::Set(d, 0.6), rx)),
                              hn::Gt(new_ry, hn::Mul(hn::Set(d, 0.6), ry)));
    const auto bits = [&](auto mask) {
        std::uint8_t b8[8] = {};
        hn::StoreMaskBits(d, mask, b8);
        return static_cast<std::uint8_t>(b8[0] << lane);
    };
    const auto root = hn::And(single, hn::Or(close, poor));
    b.left = static_cast<std::uint8_t>(b.left | bits(hn::Not(empty)));
    b.single = static_cast<std::uint8_t>(b.single | bits(single));
    b.root = static_cast<std::uint8_t>(b.root | bits(root));
    b.poor = static_cast<std::uint8_t>(b.poor | bits(hn::AndNot(single, poor)));
    // Of a root Newton's own place and bound, not the middle of what two boxes have in common.
    const auto store_place = [&](V newton, V low, V high, V old, double* to) {
        const V on_leaf = hn::Min(hn::Max(newton, hn::Neg(one)), one);
        const V middle = hn::IfThenElse(sane, hn::Mul(half, hn::Add(low, high)), old);
        hn::Store(hn::IfThenElse(root, on_leaf, middle), d, to + lane);
    };
    store_place(hn::Add(x, dx), low_x, high_x, x, b.x.data());
    store_place(hn::Add(y, dy), low_y, high_y, y, b.y.data());
    hn::Store(hn::IfThenElse(root, rest_x, new_rx), d, b.half_x.data() + lane);
    hn::Store(hn::IfThenElse(root, rest_y, new_ry), d, b.half_y.data() + lane);
}

using Wide = hn::CappedTag<double, 8>;
using One = hn::CappedTag<double, 1>;

std::size_t narrow(const PlanePair& planes, const HotLeaf& leaf, const Component4* polynomial,
                   std::size_t count, LeafBox* boxes) {
    NarrowedBoxes b;
    for (std::size_t i = 0; i < 8; ++i) {
        const LeafBox& from = boxes[i < count ? i : 0];
        b.x[i] = from.x;
        b.y[i] = from.y;
        b.half_x[i] = from.half_x;
        b.half_y[i] = from.half_y;
    }
    for (std::size_t lane = 0; lane < count; lane += hn::Lanes(Wide()))
        narrow_lanes(Wide(), planes, leaf, polynomial, b, lane);
    std::size_t kept = 0;
    std::array<LeafBox, 16> result;
    for (std::size_t i = 0; i < count; ++i) {
        const auto has = [&](std::uint8_t set) { return (set >> i & 1) != 0; };
        if (!has(b.left)) continue;
        LeafBox box{b.x[i], b.y[i], b.half_x[i], b.half_y[i], has(b.single), has(b.root)};
        if (has(b.poor) && !box.root) {
            double& place = box.half_x >= box.half_y ? box.x : box.y;
            double& half = box.half_x >= box.half_y ? box.half_x : box.half_y;
            half /= 2;
            const double middle = place;
            place = middle - half;
            result[kept++] = box;
            place = middle + half;
        }
        result[kept++] = box;
    }
    std::copy_n(result.begin(), kept, boxes);
    return kept;
}

/// Calls `work(first lane)` for each vector that has a lane in the mask.
template <class Work>
void for_vectors(LaneMask mask, const Work& work) {
    const std::size_t width = hn::Lanes(Wide());
    const LaneMask all = (LaneMask{1} << width) - 1;
    for (std::size_t lane = 0; lane < RayBlock::capacity; lane += width)
        if ((mask >> lane & all) != 0) work(lane);
}

void look(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.single = result.undecided = 0;
    for_vectors(mask, [&](std::size_t lane) { look_at(Wide(), rays, lane, leaf, result); });
    result.certain &= mask;
    result.single &= mask;
    result.undecided &= mask;
}

void look_single(const RayBlock& rays, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.single = result.undecided = 0;
    look_at(One(), rays, 0, leaf, result);
}

void solve(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, const Component4* polynomial,
           LeafRoots& result) {
    result.found = result.failed = 0;
    for_vectors(mask, [&](std::size_t lane) {
        result.found |= solve_lanes(Wide(), rays, lane, mask, leaf, polynomial, result);
    });
}

void solve_single(const RayBlock& rays, const HotLeaf& leaf, const Component4* polynomial,
                  LeafRoots& result) {
    result.found = result.failed = 0;
    result.found = solve_lanes(One(), rays, 0, 1, leaf, polynomial, result);
}

LeafKernels kernels() {
    return {hwy::TargetName(HWY_TARGET), look, look_single, solve, solve_single, narrow};
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace keiko {

HWY_EXPORT(kernels);

LeafKernels leaf_kernels() {
    return HWY_DYNAMIC_DISPATCH(kernels)();
}

} // namespace keiko
#endif
