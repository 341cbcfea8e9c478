// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_KRAWCZYK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_KRAWCZYK_INL_H
#undef KEIKO_TRACE_KRAWCZYK_INL_H
#else
#define KEIKO_TRACE_KRAWCZYK_INL_H
#endif

#include "keiko/trace/newton-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

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

/// A step of Krawczyk's method in a vector of boxes: in a box around z of half size r, with J the
/// Jacobian at z, every root is within J^-1 (K r^2 / 2 + noise) of Newton's z - J^-1 F(z); where
/// |J^-1| K r is below 1 there is at most one.
template <class D>
class KrawczykStep {
    using V = hn::Vec<D>;
    using Pair = std::array<V, 2>; ///< one a plane

public:
    /// Of the first `count` boxes; anything in the others.
    KrawczykStep(const PlanePair& planes, const SameLeaf& leaf, const Boxes<V>& boxes,
                 std::size_t count)
        : boxes_(boxes), r_(hn::Max(boxes.half_x, boxes.half_y)) {
        const Jet<V> at = jet_of_first(d_, leaf, count, boxes.x, boxes.y);
        value_ = seen(planes, at.value);
        by_x_ = seen(planes, at.by_x);
        by_y_ = seen(planes, at.by_y);
        scale_ = hn::Div(one(), hn::NegMulAdd(by_y_[0], by_x_[1], hn::Mul(by_x_[0], by_y_[1])));
        noise_ = {hn::Set(d_, planes.noise[0]), hn::Set(d_, planes.noise[1])};
        bend_ = {hn::Set(d_, planes.bend[0]), hn::Set(d_, planes.bend[1])};
        const V degrees = hn::Set(d_, degrees_of(leaf.shape()));
        rest_ = {rest(0, degrees), rest(1, degrees)};
    }

    NarrowedBoxes<D> narrowed() const {
        const auto& [f, g] = value_;
        const V newton_x =
            hn::MulAdd(hn::NegMulAdd(by_y_[1], f, hn::Mul(by_y_[0], g)), scale_, boxes_.x);
        const V newton_y =
            hn::MulAdd(hn::NegMulAdd(by_x_[0], g, hn::Mul(by_x_[1], f)), scale_, boxes_.y);
        const Range x = range(boxes_.x, boxes_.half_x, newton_x, spread(by_y_, rest_));
        const Range y = range(boxes_.y, boxes_.half_y, newton_y, spread(by_x_, rest_));
        // Where J is singular Newton says nothing, not even that: the box stays as it was.
        const auto sane = hn::And(hn::Le(x.low, x.high), hn::Le(y.low, y.high));
        const auto empty = hn::Or(hn::Or(hn::Gt(x.low, x.high), hn::Gt(y.low, y.high)),
                                  hn::Or(is_clear(0), is_clear(1)));
        const V half_x = half_of(x, sane, boxes_.half_x), half_y = half_of(y, sane, boxes_.half_y);
        const auto poor =
            hn::And(hardly_less(half_x, boxes_.half_x), hardly_less(half_y, boxes_.half_y));
        const V contraction = widest({hn::Mul(bend_[0], r_), hn::Mul(bend_[1], r_)});
        const auto single = hn::Lt(contraction, hn::Set(d_, largest_contraction));
        const auto close = hn::Le(hn::Mul(contraction, r_), far_below(d_, widest(noise_)));
        const auto root = hn::And(single, hn::Or(close, poor));
        return {{place(x, sane, root, boxes_.x), place(y, sane, root, boxes_.y),
                 hn::IfThenElse(root, x.rest, half_x), hn::IfThenElse(root, y.rest, half_y)},
                hn::Not(empty),
                single,
                root,
                poor};
    }

private:
    /// Along one parameter: Newton's place, how far a root may be from it, and the part of the box
    /// that is left.
    struct Range {
        V newton, rest, low, high;
    };

    static V one() { return hn::Set(d_, 1); }

    static Pair seen(const PlanePair& planes, const std::array<V, 4>& c) {
        const auto by = [&](const Component4& w) {
            return hn::MulAdd(
                hn::Set(d_, w[3]), c[3],
                hn::MulAdd(hn::Set(d_, w[2]), c[2],
                           hn::MulAdd(hn::Set(d_, w[1]), c[1], hn::Mul(hn::Set(d_, w[0]), c[0]))));
        };
        return {by(planes.weights[0]), by(planes.weights[1])};
    }

    /// Of Taylor's formula, with the rounding; that of the Jacobian as in newton-inl.h.
    V rest(std::size_t plane, V degrees) const {
        const V half_square = hn::Mul(hn::Mul(hn::Set(d_, 0.5), r_), r_);
        const V turned = hn::Mul(noise_[plane], degrees);
        return hn::MulAdd(bend_[plane], half_square, hn::MulAdd(turned, r_, noise_[plane]));
    }

    /// Whether a plane passes the whole box by.
    hn::Mask<D> is_clear(std::size_t k) const {
        const V most = hn::MulAdd(hn::Abs(by_x_[k]), boxes_.half_x,
                                  hn::MulAdd(hn::Abs(by_y_[k]), boxes_.half_y, rest_[k]));
        return hn::Gt(hn::Abs(value_[k]), most);
    }

    /// What J^-1 makes of bounds of both functions, along one parameter; `by` are the derivatives
    /// by the other one.
    V spread(const Pair& by, const Pair& bounds) const {
        return hn::Mul(hn::Abs(scale_),
                       hn::MulAdd(hn::Abs(by[1]), bounds[0], hn::Mul(hn::Abs(by[0]), bounds[1])));
    }
    V widest(const Pair& bounds) const {
        return hn::Max(spread(by_y_, bounds), spread(by_x_, bounds));
    }

    static Range range(V middle, V half, V newton, V rest) {
        return {newton, rest, hn::Max(hn::Sub(middle, half), hn::Sub(newton, rest)),
                hn::Min(hn::Add(middle, half), hn::Add(newton, rest))};
    }
    static V half_of(const Range& r, hn::Mask<D> sane, V old) {
        return hn::IfThenElse(sane, hn::Mul(hn::Set(d_, 0.5), hn::Sub(r.high, r.low)), old);
    }
    static hn::Mask<D> hardly_less(V half, V old) {
        return hn::Gt(half, hn::Mul(hn::Set(d_, 0.6), old));
    }
    /// Of a root Newton's own place and bound, not the middle of what two boxes have in common.
    static V place(const Range& r, hn::Mask<D> sane, hn::Mask<D> root, V old) {
        const V on_leaf = hn::Min(hn::Max(r.newton, hn::Neg(one())), one());
        const V middle =
            hn::IfThenElse(sane, hn::Mul(hn::Set(d_, 0.5), hn::Add(r.low, r.high)), old);
        return hn::IfThenElse(root, on_leaf, middle);
    }

    static constexpr D d_{};
    Boxes<V> boxes_;
    V r_, scale_;
    Pair value_, by_x_, by_y_, noise_, bend_, rest_;
};

/// Appends the boxes of a mask to arrays. One by one: they are few, and Highway's Compress copies a
/// table of 2 kB each time it is called.
template <class D, class Arrays>
std::size_t append(D d, const Boxes<hn::Vec<D>>& b, hn::Mask<D> mask, Arrays& to,
                   std::size_t size) {
    LaneMask left = lane_bits(d, mask, 0);
    if (left == 0) return size;
    alignas(64) std::array<std::array<double, hn::MaxLanes(D())>, 4> from;
    hn::Store(b.x, d, from[0].data());
    hn::Store(b.y, d, from[1].data());
    hn::Store(b.half_x, d, from[2].data());
    hn::Store(b.half_y, d, from[3].data());
    for (; left != 0; left &= left - 1, ++size) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        to.x[size] = from[0][lane], to.y[size] = from[1][lane];
        to.half_x[size] = from[2][lane], to.half_y[size] = from[3][lane];
    }
    return size;
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
bool narrow_last(D d, const PlanePair& planes, const SameLeaf& leaf, BoxStack& stack,
                 RootBoxes& roots) {
    const std::size_t count = std::min(stack.size, hn::Lanes(d));
    stack.size -= count;
    const auto load = [&](const auto& from) { return hn::LoadU(d, from.data() + stack.size); };
    const Boxes<hn::Vec<D>> boxes{load(stack.x), load(stack.y), load(stack.half_x),
                                  load(stack.half_y)};
    const NarrowedBoxes<D> n = KrawczykStep<D>(planes, leaf, boxes, count).narrowed();
    const auto left = hn::And(n.left, hn::FirstN(d, count));
    const auto found = hn::And(left, n.root), kept = hn::AndNot(n.root, left);
    const auto wide = hn::Gt(hn::Max(n.boxes.half_x, n.boxes.half_y), hn::Set(d, narrowest));
    const auto vague = hn::Gt(hn::Max(n.boxes.half_x, n.boxes.half_y), hn::Set(d, widest_root));
    if (!hn::AllFalse(d, hn::And(found, vague))) return false;
    if (!hn::AllFalse(d, hn::AndNot(hn::Or(n.single, wide), kept))) return false;
    if (roots.count + hn::Lanes(d) > RootBoxes::capacity) return false;
    roots.count = append(d, n.boxes, found, roots, roots.count);
    push(d, n, kept, stack);
    return true;
}

/// A vector full of boxes, four along the longer side.
void fill(BoxStack& stack, const Box2& where) {
    const Vec2 extent = where.extent();
    const bool along_x = extent.x >= extent.y;
    const Vec2 count = along_x ? Vec2(4, 2) : Vec2(2, 4);
    // What rounding may leave out between neighbours.
    const Vec2 half = extent / count * 0.5 * (1 + 1e-12) + Vec2(1e-15);
    for (double i = 0; i < count.x; ++i)
        for (double j = 0; j < count.y; ++j) {
            stack.x[stack.size] = where.lower.x + extent.x * (i + 0.5) / count.x;
            stack.y[stack.size] = where.lower.y + extent.y * (j + 0.5) / count.y;
            stack.half_x[stack.size] = half.x;
            stack.half_y[stack.size++] = half.y;
        }
}

bool find_roots(const PlanePair& planes, const HotLeaf& leaf, const Component4* polynomial,
                const Box2& where, RootBoxes& roots) {
    BoxStack stack;
    fill(stack, where);
    roots.count = 0;
    for (std::size_t seen = 0; stack.size > 0; seen += hn::Lanes(Wide()))
        if (seen > most_boxes || !narrow_last(Wide(), planes, {leaf, polynomial}, stack, roots))
            return false;
    return true;
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
