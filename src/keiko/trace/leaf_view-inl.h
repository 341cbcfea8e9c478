// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_LEAF_VIEW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_LEAF_VIEW_INL_H
#undef KEIKO_TRACE_LEAF_VIEW_INL_H
#else
#define KEIKO_TRACE_LEAF_VIEW_INL_H
#endif

#include "keiko/trace/lanes-inl.h"
#include "keiko/trace/leaf_kernels.h"
#include "keiko/trace/ray_blur.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

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
    const auto bits = [&](hn::Mask<D> mask) { return lane_bits(d, mask, lane); };
    result.certain |= bits(hn::And(single, inside));
    result.single |= bits(hn::AndNot(inside, single));
    result.undecided |= bits(hn::AndNot(single, left));
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
