// Compiled once for each instruction set by sub_patch_kernels.cpp.
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

/// Krawczyk's method in one box a ray, the part of the sub-patch that the ray can meet.
template <class D>
class ParameterBoxes {
    using V = hn::Vec<D>;

public:
    ParameterBoxes(const RayPacket& rays, std::size_t lane, LaneMask wanted,
                   const SameSubPatch& sub_patch)
        : sub_patch_(sub_patch),
          lane_(lane),
          rays_(rays, lane, sub_patch.shape()),
          planes_(rays_.planes(sub_patch.shape())),
          boxes_(rays_.reachable(sub_patch.shape())) {
        std::uint8_t bits[8] = {static_cast<std::uint8_t>(wanted >> lane)};
        const auto empty = hn::Lt(hn::Min(boxes_.half_x, boxes_.half_y), hn::Zero(d_));
        active_ = hn::AndNot(empty, hn::LoadMaskBits(d_, bits));
    }

    bool working() const { return !hn::AllFalse(d_, active_); }

    void step() {
        const Jet<V> at = jet_of(d_, sub_patch_, active_, boxes_.x, boxes_.y);
        const ContractedBoxes<D> n =
            KrawczykStep<D>(planes_, sub_patch_.shape(), at, boxes_).narrowed();
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
    LaneMask write(SubPatchRoots& result) const {
        result.failed |= lane_bits(d_, hn::Or(open_, active_), lane_);
        if (hn::AllFalse(d_, found_)) return 0;
        const Jet<V> at = jet_of(d_, sub_patch_, found_, boxes_.x, boxes_.y);
        hn::Store(boxes_.x, d_, result.x.data() + lane_);
        hn::Store(boxes_.y, d_, result.y.data() + lane_);
        hn::Store(hn::Max(boxes_.half_x, boxes_.half_y), d_, result.error.data() + lane_);
        hn::Store(rays_.s_at(at.value), d_, result.s.data() + lane_);
        return lane_bits(d_, found_, lane_);
    }

private:
    static constexpr D d_{};
    SameSubPatch sub_patch_;
    std::size_t lane_;
    FrameRays<D> rays_;
    PlanePairs<V> planes_;
    Boxes<V> boxes_;
    hn::Mask<D> active_, found_ = hn::FirstN(d_, 0), open_ = hn::FirstN(d_, 0);
};

void narrow(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch,
            const Component4* polynomial, SubPatchRoots& result) {
    result.found = result.failed = 0;
    for_vectors(mask, [&](std::size_t lane) {
        ParameterBoxes<Wide> boxes(rays, lane, mask, {sub_patch, polynomial});
        for (int i = 0; i < most_narrowings && boxes.working(); ++i) boxes.step();
        result.found |= boxes.write(result);
    });
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
