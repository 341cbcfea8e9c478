// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_KRAWCZYK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_KRAWCZYK_INL_H
#undef KEIKO_INTERSECT_KRAWCZYK_INL_H
#else
#define KEIKO_INTERSECT_KRAWCZYK_INL_H
#endif

#include "keiko/intersect/kernels/existence_test-inl.h"
#include "keiko/intersect/kernels/frame_rays-inl.h"
#include "keiko/intersect/kernels/newton-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Share of the sub-patch's half size below which an undecided box is a tangency.
constexpr double narrowest = 1e-7;

/// Result of one step for a vector of boxes.
template <class D>
struct ContractedBoxes {
    Boxes<hn::Vec<D>> boxes; ///< what is left, or a root's place and bound
    hn::Mask<D> left;        ///< a root cannot be ruled out
    hn::Mask<D> single;      ///< at most one root
    hn::Mask<D> root;        ///< at most one root, to be found no better by another step
    hn::Mask<D> poor;        ///< neither side is below 0.6 of what it was
};

/// Step of Krawczyk's method [Krawczyk1969] in a vector of boxes. In a box around z of half size r,
/// with J the Jacobian at z, every root is within J^-1 (K r^2 / 2 + noise) of Newton's z - J^-1
/// F(z). Where |J^-1| K r is below 1 there is at most one.
template <class D>
class KrawczykStep {
    using V = hn::Vec<D>;
    using Pair = std::array<V, 2>; ///< one a plane

public:
    /// `at`: the sub-patch's components at the boxes' middles.
    KrawczykStep(const PlanePairs<V>& planes, const PackedSubPatch& sub_patch, const Jet<V>& at,
                 const Boxes<V>& boxes)
        : boxes_(boxes),
          r_(hn::Max(boxes.half_x, boxes.half_y)),
          value_(seen(planes, at.value)),
          by_x_(seen(planes, at.by_x)),
          by_y_(seen(planes, at.by_y)),
          noise_(planes.noise),
          bend_(planes.bend) {
        scale_ = hn::Div(one(), hn::NegMulAdd(by_y_[0], by_x_[1], hn::Mul(by_x_[0], by_y_[1])));
        const V degrees = hn::Set(d_, degrees_of(sub_patch));
        rest_ = {rest(0, degrees), rest(1, degrees)};
    }

    /// Boxes after the step.
    ContractedBoxes<D> narrowed() const {
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

    static Pair seen(const PlanePairs<V>& planes, const std::array<V, 4>& c) {
        const auto by = [&](const std::array<V, 4>& w) {
            return hn::MulAdd(w[3], c[3],
                              hn::MulAdd(w[2], c[2], hn::MulAdd(w[1], c[1], hn::Mul(w[0], c[0]))));
        };
        return {by(planes.weights[0]), by(planes.weights[1])};
    }

    /// Remainder of Taylor's formula, with the rounding; that of the Jacobian as in newton-inl.h.
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

    /// Image under J^-1 of bounds of both functions, along one parameter; `by` are the derivatives
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
    /// Place of a root: Newton's own place and bound, not the middle of the intersection of two
    /// boxes.
    static V place(const Range& r, hn::Mask<D> sane, hn::Mask<D> root, V old) {
        const V on_sub_patch = hn::Min(hn::Max(r.newton, hn::Neg(one())), one());
        const V middle =
            hn::IfThenElse(sane, hn::Mul(hn::Set(d_, 0.5), hn::Add(r.low, r.high)), old);
        return hn::IfThenElse(root, on_sub_patch, middle);
    }

    static constexpr D d_{};
    Boxes<V> boxes_;
    V r_;
    Pair value_, by_x_, by_y_, noise_, bend_;
    V scale_;
    Pair rest_;
};

/// More steps than a box needs that narrows down to a root.
constexpr int most_narrowings = 16;

/// Krawczyk's method in one box a ray, the part of the sub-patch that the ray can meet.
template <class D>
class ParameterBoxes {
    using V = hn::Vec<D>;

public:
    /// Boxes of the rays of a vector that begins at `lane`; `wanted` are lanes of the packet.
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

    /// True if any lane is undecided.
    bool working() const { return !hn::AllFalse(d_, active_); }

    /// One step for every undecided lane.
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

/// Krawczyk's method for the lanes of a mask, up to 16 steps; see SubPatchKernels::narrow.
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
