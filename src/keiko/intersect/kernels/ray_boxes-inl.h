// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_RAY_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_RAY_BOXES_INL_H
#undef KEIKO_TRACE_RAY_BOXES_INL_H
#else
#define KEIKO_TRACE_RAY_BOXES_INL_H
#endif

#include "keiko/intersect/kernels/krawczyk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// More steps than a box needs that narrows down to a root.
constexpr int most_narrowings = 16;

/// Krawczyk's method in one box a ray, the part of the leaf that the ray can meet.
template <class D>
class RayBoxes {
    using V = hn::Vec<D>;

public:
    RayBoxes(const RayBlock& rays, std::size_t lane, LaneMask wanted, const SameLeaf& leaf)
        : leaf_(leaf),
          lane_(lane),
          rays_(rays, lane, leaf.shape()),
          planes_(rays_.planes(leaf.shape())),
          boxes_(rays_.reachable(leaf.shape())) {
        std::uint8_t bits[8] = {static_cast<std::uint8_t>(wanted >> lane)};
        const auto empty = hn::Lt(hn::Min(boxes_.half_x, boxes_.half_y), hn::Zero(d_));
        active_ = hn::AndNot(empty, hn::LoadMaskBits(d_, bits));
    }

    bool working() const { return !hn::AllFalse(d_, active_); }

    void step() {
        const Jet<V> at = jet_of(d_, leaf_, active_, boxes_.x, boxes_.y);
        const NarrowedBoxes<D> n = KrawczykStep<D>(planes_, leaf_.shape(), at, boxes_).narrowed();
        const V longer = hn::Max(n.boxes.half_x, n.boxes.half_y);
        const auto vague = hn::And(n.root, hn::Gt(longer, hn::Set(d_, widest_root)));
        const auto narrow = hn::Le(longer, hn::Set(d_, narrowest));
        const auto several = hn::AndNot(hn::Or(n.root, n.single), hn::Or(n.poor, narrow));
        const auto left = hn::And(active_, n.left);
        boxes_.x = hn::IfThenElse(left, n.boxes.x, boxes_.x);
        boxes_.y = hn::IfThenElse(left, n.boxes.y, boxes_.y);
        boxes_.half_x = hn::IfThenElse(left, n.boxes.half_x, boxes_.half_x);
        boxes_.half_y = hn::IfThenElse(left, n.boxes.half_y, boxes_.half_y);
        open_ = hn::Or(open_, hn::And(left, hn::Or(vague, several)));
        found_ = hn::Or(found_, hn::And(left, hn::AndNot(vague, n.root)));
        active_ = hn::AndNot(hn::Or(found_, open_), left);
    }

    /// Returns the lanes that have a root.
    LaneMask write(LeafRoots& result) const {
        result.failed |= lane_bits(d_, hn::Or(open_, active_), lane_);
        if (hn::AllFalse(d_, found_)) return 0;
        const Jet<V> at = jet_of(d_, leaf_, found_, boxes_.x, boxes_.y);
        hn::Store(boxes_.x, d_, result.x.data() + lane_);
        hn::Store(boxes_.y, d_, result.y.data() + lane_);
        hn::Store(hn::Max(boxes_.half_x, boxes_.half_y), d_, result.error.data() + lane_);
        hn::Store(rays_.s_at(at.value), d_, result.s.data() + lane_);
        return lane_bits(d_, found_, lane_);
    }

private:
    static constexpr D d_{};
    SameLeaf leaf_;
    std::size_t lane_;
    FrameRays<D> rays_;
    PlanePairs<V> planes_;
    Boxes<V> boxes_;
    hn::Mask<D> active_, found_ = hn::FirstN(d_, 0), open_ = hn::FirstN(d_, 0);
};

void narrow(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, const Component4* polynomial,
            LeafRoots& result) {
    result.found = result.failed = 0;
    for_vectors(mask, [&](std::size_t lane) {
        RayBoxes<Wide> boxes(rays, lane, mask, {leaf, polynomial});
        for (int i = 0; i < most_narrowings && boxes.working(); ++i) boxes.step();
        result.found |= boxes.write(result);
    });
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
