// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_KRAWCZYK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_KRAWCZYK_INL_H
#undef KEIKO_TRACE_KRAWCZYK_INL_H
#else
#define KEIKO_TRACE_KRAWCZYK_INL_H
#endif

#include "keiko/trace/newton-inl.h"

#include <algorithm>

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

/// Krawczyk's method: in a box around z of half size r, with J the Jacobian at z, every root is
/// within J^-1 (K r^2 / 2 + noise) of Newton's z - J^-1 F(z); where |J^-1| K r is below 1 there is
/// at most one.
template <class D>
NarrowedBoxes<D> narrowed(D d, const PlanePair& planes, const SameLeaf& leaf,
                          const Boxes<hn::Vec<D>>& b) {
    using V = hn::Vec<D>;
    const Jet<V> at = jet_of(d, leaf, b.x, b.y);
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
        // As in newton-inl.h, for the rounding of the Jacobian.
        const V noise = hn::Set(d, planes.noise[plane]);
        const V turned = hn::Mul(noise, hn::Set(d, degrees_of(leaf.shape())));
        return hn::MulAdd(hn::Set(d, planes.bend[plane]), half_square,
                          hn::MulAdd(turned, r, noise));
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
bool narrow_last(D d, const PlanePair& planes, const SameLeaf& leaf, BoxStack& stack,
                 RootBoxes& roots) {
    const std::size_t count = std::min(stack.size, hn::Lanes(d));
    stack.size -= count;
    const auto load = [&](const auto& from) { return hn::LoadU(d, from.data() + stack.size); };
    const NarrowedBoxes<D> n = narrowed(
        d, planes, leaf, {load(stack.x), load(stack.y), load(stack.half_x), load(stack.half_y)});
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
