#include "keiko/trace/leaf_kernels.h"

#include "keiko/trace/ray_blur.h"

#include <algorithm>
#include <bit>
#include <limits>

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

/// A mask of a vector that begins at `lane`, by lanes of the block.
template <class D>
LaneMask lane_bits(D d, hn::Mask<D> mask, std::size_t lane) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return static_cast<LaneMask>(bits[0]) << lane;
}

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

constexpr double infinity = std::numeric_limits<double>::infinity();

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
    const auto bits = [&](hn::Mask<D> mask) { return lane_bits(d, mask, lane); };
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
    const auto bits = [&](hn::Mask<D> mask) { return lane_bits(d, mask, lane); };
    result.failed |= bits(active);
    return bits(found);
}

/// The start moved up to the ball; no lane of the result that has no direction, or misses it.
template <class D>
LaneMask enter_lanes(D d, const SceneBall& scene, RayBlock& rays, std::size_t lane) {
    using V = hn::Vec<D>;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const auto load = [&](const RayBlock::Lanes<double>& from) {
        return hn::Load(d, from.data() + lane);
    };
    const auto store = [&](V value, RayBlock::Lanes<double>& to) {
        hn::Store(value, d, to.data() + lane);
    };
    const auto set = [&](double x) { return hn::Set(d, x); };
    const auto dot = [&](const std::array<V, 3>& a, const std::array<V, 3>& b) {
        return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
    };
    const std::array<V, 3> origin{load(rays.start[0]), load(rays.start[1]), load(rays.start[2])};
    const std::array<V, 3> given{load(rays.direction[0]), load(rays.direction[1]),
                                 load(rays.direction[2])};
    const V speed = hn::Sqrt(dot(given, given));
    std::array<V, 3> direction, to_center, off;
    for (unsigned k = 0; k < 3; ++k) {
        direction[k] = hn::Div(given[k], speed);
        to_center[k] = hn::Sub(set(scene.center[k]), origin[k]);
    }
    const V foot = dot(to_center, direction), away = hn::Sqrt(dot(to_center, to_center));
    for (unsigned k = 0; k < 3; ++k) off[k] = hn::NegMulAdd(direction[k], foot, to_center[k]);
    // Far origins blur the ball's border: whatever may touch it must come in.
    const V ball = hn::MulAdd(set(64 * epsilon), away, set(scene.radius * 1.001));
    const V half_square = hn::NegMulAdd(
        off[0], off[0],
        hn::NegMulAdd(off[1], off[1], hn::NegMulAdd(off[2], off[2], hn::Mul(ball, ball))));
    const V half = hn::Sqrt(half_square);
    // Not t_min: a hit's t must have the same last bit whatever range it is asked in.
    const auto inside = hn::Le(away, ball);
    const V t_start = hn::IfThenZeroElse(inside, hn::Div(hn::Sub(foot, half), speed));
    for (unsigned k = 0; k < 3; ++k) {
        store(hn::MulAdd(given[k], t_start, origin[k]), rays.start[k]);
        store(direction[k], rays.direction[k]);
    }
    const V way = hn::Mul(t_start, speed);
    const V slack = hn::Mul(set(8 * epsilon), hn::Add(away, ball));
    const V error = hn::Mul(set(2 * epsilon), hn::Add(hn::Sqrt(dot(origin, origin)), hn::Abs(way)));
    const V t_low = hn::Mul(load(rays.low), speed), t_high = hn::Mul(load(rays.high), speed);
    const V low = hn::Sub(hn::Sub(hn::Max(t_low, hn::Sub(foot, half)), way), slack);
    const V high = hn::Add(hn::Sub(hn::Min(t_high, hn::Add(foot, half)), way), slack);
    store(low, rays.low);
    store(high, rays.high);
    store(t_start, rays.t_start);
    store(speed, rays.speed);
    store(error, rays.error);
    store(slack, rays.slack);
    // No leaf's frame is centred farther away than across the ball.
    store(hn::Add(error, set(ray_rounding * 2.5 * scene.radius)), rays.blur);
    return lane_bits(d,
                     hn::And(hn::And(hn::Gt(speed, hn::Zero(d)), hn::Lt(speed, set(infinity))),
                             hn::And(hn::Ge(half_square, hn::Zero(d)),
                                     hn::And(hn::Le(t_low, t_high), hn::Le(low, high)))),
                     lane);
}

/// Boxes that may hold roots; a vector may be read or written past the last.
struct BoxStack {
    static constexpr std::size_t capacity = 512, margin = 16;

    std::size_t size = 0;
    alignas(64) std::array<double, capacity + margin> x, y, half_x, half_y;
};

/// Boxes of one vector.
template <class V>
struct Boxes {
    V x, y, half_x, half_y;
};

/// What one step makes of a vector of boxes.
template <class D>
struct NarrowedBoxes {
    Boxes<hn::Vec<D>> boxes;
    hn::Mask<D> left, single, root, poor;
};

/// Krawczyk's method: in a box around z of half size r, with J the Jacobian at z, every root is
/// within J^-1 (K r^2 / 2 + noise) of Newton's z - J^-1 F(z); where |J^-1| K r is below 1 there is
/// at most one.
template <class D>
NarrowedBoxes<D> narrowed(D d, const PlanePair& planes, const HotLeaf& leaf,
                          const Component4* polynomial, const Boxes<hn::Vec<D>>& b) {
    using V = hn::Vec<D>;
    const Jet<V> at = jet_of(d, leaf, polynomial, b.x, b.y);
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
    const V one = hn::Set(d, 1), half = hn::Set(d, 0.5);
    const V r = hn::Max(b.half_x, b.half_y), half_square = hn::Mul(hn::Mul(half, r), r);
    const auto rest = [&](std::size_t plane) {
        return hn::MulAdd(hn::Set(d, planes.bend[plane]), half_square,
                          hn::Set(d, planes.noise[plane]));
    };
    const V rest_f = rest(0), rest_g = rest(1);
    const auto clear = [&](V value, V by_x, V by_y, V remainder) {
        return hn::Gt(hn::Abs(value), hn::MulAdd(hn::Abs(by_x), b.half_x,
                                                 hn::MulAdd(hn::Abs(by_y), b.half_y, remainder)));
    };
    const V scale = hn::Div(one, hn::NegMulAdd(fy, gx, hn::Mul(fx, gy)));
    const V newton_x = hn::MulAdd(hn::NegMulAdd(gy, f, hn::Mul(fy, g)), scale, b.x);
    const V newton_y = hn::MulAdd(hn::NegMulAdd(fx, g, hn::Mul(gx, f)), scale, b.y);
    const auto spread = [&](V along_g, V along_f, V first, V second) {
        return hn::Mul(hn::Abs(scale),
                       hn::MulAdd(hn::Abs(along_g), first, hn::Mul(hn::Abs(along_f), second)));
    };
    const auto widest = [&](V first, V second) {
        return hn::Max(spread(gy, fy, first, second), spread(gx, fx, first, second));
    };
    const V rest_x = spread(gy, fy, rest_f, rest_g), rest_y = spread(gx, fx, rest_f, rest_g);
    const V contraction =
        widest(hn::Mul(hn::Set(d, planes.bend[0]), r), hn::Mul(hn::Set(d, planes.bend[1]), r));
    const V noise = widest(hn::Set(d, planes.noise[0]), hn::Set(d, planes.noise[1]));

    const V low_x = hn::Max(hn::Sub(b.x, b.half_x), hn::Sub(newton_x, rest_x));
    const V high_x = hn::Min(hn::Add(b.x, b.half_x), hn::Add(newton_x, rest_x));
    const V low_y = hn::Max(hn::Sub(b.y, b.half_y), hn::Sub(newton_y, rest_y));
    const V high_y = hn::Min(hn::Add(b.y, b.half_y), hn::Add(newton_y, rest_y));
    // Where J is singular Newton says nothing, not even that: the box stays as it was.
    const auto sane = hn::And(hn::Le(low_x, high_x), hn::Le(low_y, high_y));
    const auto empty = hn::Or(hn::Or(hn::Gt(low_x, high_x), hn::Gt(low_y, high_y)),
                              hn::Or(clear(f, fx, fy, rest_f), clear(g, gx, gy, rest_g)));
    const V half_x = hn::IfThenElse(sane, hn::Mul(half, hn::Sub(high_x, low_x)), b.half_x);
    const V half_y = hn::IfThenElse(sane, hn::Mul(half, hn::Sub(high_y, low_y)), b.half_y);
    const auto poor = hn::And(hn::Gt(half_x, hn::Mul(hn::Set(d, 0.6), b.half_x)),
                              hn::Gt(half_y, hn::Mul(hn::Set(d, 0.6), b.half_y)));
    const auto single = hn::Lt(contraction, hn::Set(d, largest_contraction));
    const auto close = hn::Le(hn::Mul(contraction, r), far_below(d, noise));
    const auto root = hn::And(single, hn::Or(close, poor));
    // Of a root Newton's own place and bound, not the middle of what two boxes have in common.
    const auto place = [&](V newton, V low, V high, V old) {
        const V on_leaf = hn::Min(hn::Max(newton, hn::Neg(one)), one);
        const V middle = hn::IfThenElse(sane, hn::Mul(half, hn::Add(low, high)), old);
        return hn::IfThenElse(root, on_leaf, middle);
    };
    return {{place(newton_x, low_x, high_x, b.x), place(newton_y, low_y, high_y, b.y),
             hn::IfThenElse(root, rest_x, half_x), hn::IfThenElse(root, rest_y, half_y)},
            hn::Not(empty),
            single,
            root,
            poor};
}

/// Appends the boxes of a mask to arrays with room for a vector.
template <class D, class Arrays>
std::size_t append(D d, const Boxes<hn::Vec<D>>& b, hn::Mask<D> mask, Arrays& to,
                   std::size_t size) {
    hn::CompressStore(b.x, mask, d, to.x.data() + size);
    hn::CompressStore(b.y, mask, d, to.y.data() + size);
    hn::CompressStore(b.half_x, mask, d, to.half_x.data() + size);
    hn::CompressStore(b.half_y, mask, d, to.half_y.data() + size);
    return size + hn::CountTrue(d, mask);
}

/// Puts what is left of boxes back, those that hardly shrank in two halves.
template <class D>
void push(D d, const NarrowedBoxes<D>& n, hn::Mask<D> kept, BoxStack& stack) {
    using V = hn::Vec<D>;
    const auto split = hn::AndNot(n.single, n.poor);
    const auto across = hn::Ge(n.boxes.half_x, n.boxes.half_y);
    const auto by_x = hn::And(split, across), by_y = hn::AndNot(across, split);
    const V half = hn::Set(d, 0.5), zero = hn::Zero(d);
    const V step_x = hn::IfThenElse(by_x, hn::Mul(half, n.boxes.half_x), zero);
    const V step_y = hn::IfThenElse(by_y, hn::Mul(half, n.boxes.half_y), zero);
    const V half_x = hn::Sub(n.boxes.half_x, step_x), half_y = hn::Sub(n.boxes.half_y, step_y);
    const Boxes<V> first{hn::Sub(n.boxes.x, step_x), hn::Sub(n.boxes.y, step_y), half_x, half_y};
    const Boxes<V> second{hn::Add(n.boxes.x, step_x), hn::Add(n.boxes.y, step_y), half_x, half_y};
    stack.size = append(d, first, kept, stack, stack.size);
    stack.size = append(d, second, hn::And(kept, split), stack, stack.size);
}

/// More boxes than rays need that are not tangent to within rounding.
constexpr std::size_t most_boxes = 400;
/// Of the leaf's half size: what is narrower and still undecided is a tangency.
constexpr double narrowest = 1e-7;

/// One step for the last boxes of a stack; false when it leads nowhere.
template <class D>
bool narrow_last(D d, const PlanePair& planes, const HotLeaf& leaf, const Component4* polynomial,
                 BoxStack& stack, RootBoxes& roots) {
    const std::size_t count = std::min(stack.size, hn::Lanes(d));
    stack.size -= count;
    const auto load = [&](const auto& from) { return hn::LoadU(d, from.data() + stack.size); };
    const NarrowedBoxes<D> n =
        narrowed(d, planes, leaf, polynomial,
                 {load(stack.x), load(stack.y), load(stack.half_x), load(stack.half_y)});
    const auto left = hn::And(n.left, hn::FirstN(d, count));
    const auto found = hn::And(left, n.root), kept = hn::AndNot(n.root, left);
    const auto wide = hn::Gt(hn::Max(n.boxes.half_x, n.boxes.half_y), hn::Set(d, narrowest));
    if (!hn::AllFalse(d, hn::AndNot(hn::Or(n.single, wide), kept))) return false;
    if (roots.count + hn::Lanes(d) > RootBoxes::capacity) return false;
    roots.count = append(d, n.boxes, found, roots, roots.count);
    push(d, n, kept, stack);
    return true;
}

using Wide = hn::CappedTag<double, 8>;
using One = hn::CappedTag<double, 1>;

bool find_roots(const PlanePair& planes, const HotLeaf& leaf, const Component4* polynomial,
                RootBoxes& roots) {
    BoxStack stack;
    // A vector full of them, from the first step on.
    for (const double x : {-0.75, -0.25, 0.25, 0.75})
        for (const double y : {-0.5, 0.5}) {
            stack.x[stack.size] = x;
            stack.y[stack.size] = y;
            stack.half_x[stack.size] = 0.25;
            stack.half_y[stack.size++] = 0.5;
        }
    roots.count = 0;
    for (std::size_t seen = 0; stack.size > 0; seen += hn::Lanes(Wide()))
        if (seen > most_boxes || !narrow_last(Wide(), planes, leaf, polynomial, stack, roots))
            return false;
    return true;
}

/// Whether all active rays are close to the first, in direction and in where they start.
bool are_coherent(const SceneBall& scene, const RayBlock& rays) {
    constexpr double widest_turn = 0.1, widest_spread = 0.1;
    const Wide d;
    const auto first = static_cast<std::size_t>(std::countr_zero(rays.active));
    const auto limit = [&](double x) { return hn::Set(d, x * x); };
    for (std::size_t lane = 0; lane < rays.count; lane += hn::Lanes(d)) {
        const auto apart = [&](const std::array<RayBlock::Lanes<double>, 3>& a) {
            auto sum = hn::Zero(d);
            for (unsigned k = 0; k < 3; ++k) {
                const auto off = hn::Sub(hn::Load(d, a[k].data() + lane), hn::Set(d, a[k][first]));
                sum = hn::MulAdd(off, off, sum);
            }
            return sum;
        };
        const auto close = hn::And(hn::Lt(apart(rays.direction), limit(widest_turn)),
                                   hn::Lt(apart(rays.start), limit(widest_spread * scene.radius)));
        const LaneMask here = ((LaneMask{1} << hn::Lanes(d)) - 1) << lane;
        if ((rays.active & here & ~lane_bits(d, close, lane)) != 0) return false;
    }
    return true;
}

/// Calls `work(first lane)` for each vector that has a lane in the mask.
template <class Work>
void for_vectors(LaneMask mask, const Work& work) {
    const std::size_t width = hn::Lanes(Wide());
    const LaneMask all = (LaneMask{1} << width) - 1;
    for (std::size_t lane = 0; lane < RayBlock::capacity; lane += width)
        if ((mask >> lane & all) != 0) work(lane);
}

void enter(const SceneBall& scene, RayBlock& rays) {
    for (std::size_t lane = 0; lane < rays.count; ++lane) {
        const Ray& ray = *rays.rays[lane];
        for (unsigned k = 0; k < 3; ++k) {
            rays.start[k][lane] = ray.origin[k];
            rays.direction[k][lane] = ray.direction[k];
        }
        rays.low[lane] = ray.t_min;
        rays.high[lane] = ray.t_max;
    }
    if (rays.count == 1) {
        rays.active = enter_lanes(One(), scene, rays, 0);
        return;
    }
    const auto used = static_cast<LaneMask>((std::uint64_t{1} << rays.count) - 1);
    rays.active = 0;
    for_vectors(used,
                [&](std::size_t lane) { rays.active |= enter_lanes(Wide(), scene, rays, lane); });
    rays.active &= used;
    rays.coherent = rays.active != 0 && are_coherent(scene, rays);
}

void look(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.single = result.undecided = 0;
    for_vectors(mask, [&](std::size_t lane) { look_at(Wide(), rays, lane, leaf, result); });
    result.certain &= mask;
    result.single &= mask;
    result.undecided &= mask;
}

void look_single(const RayBlock& rays, std::size_t lane, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.single = result.undecided = 0;
    look_at(One(), rays, lane, leaf, result);
}

void solve(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, const Component4* polynomial,
           LeafRoots& result) {
    result.found = result.failed = 0;
    for_vectors(mask, [&](std::size_t lane) {
        result.found |= solve_lanes(Wide(), rays, lane, mask, leaf, polynomial, result);
    });
}

void solve_single(const RayBlock& rays, std::size_t lane, const HotLeaf& leaf,
                  const Component4* polynomial, LeafRoots& result) {
    result.found = result.failed = 0;
    result.found = solve_lanes(One(), rays, lane, LaneMask{1} << lane, leaf, polynomial, result);
}

LeafKernels kernels() {
    return {hwy::TargetName(HWY_TARGET), enter, look, look_single, solve, solve_single, find_roots};
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
