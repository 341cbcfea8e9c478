// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_SUBDIVISION_SEARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_SUBDIVISION_SEARCH_INL_H
#undef KEIKO_INTERSECT_SUBDIVISION_SEARCH_INL_H
#else
#define KEIKO_INTERSECT_SUBDIVISION_SEARCH_INL_H
#endif

#include "keiko/intersect/kernels/krawczyk-inl.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Boxes that may hold roots; a vector may be read or written past the last.
struct BoxStack {
    static constexpr std::size_t capacity = 512; ///< most boxes
    static constexpr std::size_t margin = 16;    ///< room behind the last for vectors

    std::size_t size = 0;                                  ///< boxes on the stack
    using Numbers = std::array<double, capacity + margin>; ///< One number of each box.
    alignas(64) Numbers x;                                 ///< middle
    alignas(64) Numbers y;                                 ///< middle
    alignas(64) Numbers half_x;                            ///< half size
    alignas(64) Numbers half_y;                            ///< half size
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
void push(D d, const ContractedBoxes<D>& n, hn::Mask<D> kept, BoxStack& stack) {
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

/// One step for the last boxes of a stack; false when it leads nowhere.
template <class D>
bool narrow_last(D d, const PlanePairs<hn::Vec<D>>& planes, const SameSubPatch& sub_patch,
                 BoxStack& stack, RootBoxes& roots) {
    const std::size_t count = std::min(stack.size, hn::Lanes(d));
    stack.size -= count;
    const auto load = [&](const auto& from) { return hn::LoadU(d, from.data() + stack.size); };
    const Boxes<hn::Vec<D>> boxes{load(stack.x), load(stack.y), load(stack.half_x),
                                  load(stack.half_y)};
    const Jet<hn::Vec<D>> at = jet_of_first(d, sub_patch, count, boxes.x, boxes.y);
    const ContractedBoxes<D> n = KrawczykStep<D>(planes, sub_patch.shape(), at, boxes).narrowed();
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
void fill(BoxStack& stack, const Boxes<hn::Vec<One>>& where) {
    const double width = hn::GetLane(where.half_x), height = hn::GetLane(where.half_y);
    const bool along_x = width >= height;
    const int columns = along_x ? 4 : 2, rows = along_x ? 2 : 4;
    // What rounding may leave out between neighbours.
    const double half_x = width / columns * (1 + 1e-12) + 1e-15;
    const double half_y = height / rows * (1 + 1e-12) + 1e-15;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            stack.x[stack.size] = hn::GetLane(where.x) + width * ((2 * i + 1.0) / columns - 1);
            stack.y[stack.size] = hn::GetLane(where.y) + height * ((2 * j + 1.0) / rows - 1);
            stack.half_x[stack.size] = half_x;
            stack.half_y[stack.size++] = half_y;
        }
}

/// Plane pairs of one ray, copied into all lanes.
template <class D>
PlanePairs<hn::Vec<D>> in_all_lanes(D d, const PlanePairs<hn::Vec<One>>& one) {
    PlanePairs<hn::Vec<D>> all;
    const auto set = [&](hn::Vec<One> from, hn::Vec<D>& to) { to = hn::Set(d, hn::GetLane(from)); };
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t c = 0; c < 4; ++c) set(one.weights[k][c], all.weights[k][c]);
        set(one.bend[k], all.bend[k]);
        set(one.noise[k], all.noise[k]);
    }
    return all;
}

/// Distances along the ray of the roots' places.
void set_distances(const FrameRays<One>& ray, const SameSubPatch& sub_patch, RootBoxes& roots) {
    const One d;
    for (std::size_t i = 0; i < roots.count; ++i) {
        const auto at = jet_of(d, sub_patch, hn::Set(d, roots.x[i]), hn::Set(d, roots.y[i]));
        roots.s[i] = hn::GetLane(ray.s_at(at.value));
    }
}

/// All roots of one lane on a sub-patch; see SubPatchKernels::find_roots.
bool find_roots(const RayPacket& rays, std::size_t lane, const PackedSubPatch& sub_patch,
                const Component4* polynomial, RootBoxes& roots) {
    const FrameRays<One> ray(rays, lane, sub_patch);
    const Boxes<hn::Vec<One>> where = ray.reachable(sub_patch);
    roots.count = 0;
    if (hn::GetLane(where.half_x) < 0 || hn::GetLane(where.half_y) < 0) return true;
    const Wide d;
    const auto planes = in_all_lanes(d, ray.planes(sub_patch));
    const SameSubPatch same{sub_patch, polynomial};
    BoxStack stack;
    fill(stack, where);
    for (std::size_t seen = 0; stack.size > 0; seen += hn::Lanes(d))
        if (seen > most_boxes || !narrow_last(d, planes, same, stack, roots)) return false;
    set_distances(ray, same, roots);
    return true;
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
