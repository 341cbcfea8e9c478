// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_EXISTENCE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_EXISTENCE_TEST_INL_H
#undef KEIKO_INTERSECT_EXISTENCE_TEST_INL_H
#else
#define KEIKO_INTERSECT_EXISTENCE_TEST_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/sub_patch_jet-inl.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/subpatch/packed_sub_patch.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Two planes through each ray of a vector, X = a + p Z and Y = b + q Z in the frame of a
/// sub-patch. The ray meets the frame's plane at (a, b), moving by (p, q) for each unit of height.
/// Bounds hold over the sub-patch.
template <class D>
struct RayPlanes {
    using V = hn::Vec<D>; ///< One number of each ray.

    V a, b;           ///< place in the frame's plane
    V p, q;           ///< change of the place for a unit of height
    V depth;          ///< mm along the ray to the plane
    V step;           ///< mm along the ray for a unit of height
    V steep;          ///< |step| times the length of the height's row: 1 / cosine
    V blur_u, blur_v; ///< of a and b, with all that the sub-patch's own blur adds
    V contraction;    ///< of SubPatchFrame, for this ray

    /// Planes through the rays of a vector that begins at `lane`. Rays along the frame's plane get
    /// infinite or undefined numbers.
    template <class SubPatches>
    RayPlanes(D d, const RayPacket& rays, std::size_t lane, const SubPatches& sub_patches) {
        set_place(d, rays, lane, sub_patches);
        set_blur(d, rays, lane, sub_patches);
        set_bounds(d, sub_patches);
    }

    /// Half width of the strip around a that the x of a root lies in.
    V strip_u() const { return strip_u_; }
    /// Half width of the strip around b that the y of a root lies in.
    V strip_v() const { return strip_v_; }
    /// mm: a root's distance along the ray is within it of `depth`.
    V reach() const { return reach_; }
    /// Bound of the second derivatives |xx| + 2 |xy| + |yy| of the functions that a root zeroes.
    V bend() const { return bend_; }

private:
    template <class SubPatches>
    void set_place(D d, const RayPacket& rays, std::size_t lane, const SubPatches& sub_patches) {
        const auto get = [&](const auto& read) { return sub_patches.number(d, read); };
        const auto away = [&](std::size_t k) {
            return hn::Sub(
                hn::Load(d, rays.start[k].data() + lane),
                get([k](const PackedSubPatch& h) -> const double& { return h.center[k]; }));
        };
        const V o0 = away(0), o1 = away(1), o2 = away(2);
        const auto along = [&](std::size_t k) {
            return hn::Load(d, rays.direction[k].data() + lane);
        };
        const V d0 = along(0), d1 = along(1), d2 = along(2);
        const auto row = [&](std::size_t r, V x, V y, V z) {
            const auto entry = [&](std::size_t k) {
                return get(
                    [r, k](const PackedSubPatch& h) -> const double& { return h.rows[r][k]; });
            };
            return hn::MulAdd(entry(2), z, hn::MulAdd(entry(1), y, hn::Mul(entry(0), x)));
        };
        step = hn::Div(hn::Set(d, 1), row(2, d0, d1, d2));
        const V height = row(2, o0, o1, o2);
        p = hn::Mul(row(0, d0, d1, d2), step);
        q = hn::Mul(row(1, d0, d1, d2), step);
        a = hn::NegMulAdd(height, p, row(0, o0, o1, o2));
        b = hn::NegMulAdd(height, q, row(1, o0, o1, o2));
        depth = hn::Neg(hn::Mul(height, step));
    }

    template <class SubPatches>
    void set_blur(D d, const RayPacket& rays, std::size_t lane, const SubPatches& sub_patches) {
        const auto get = [&](const auto& read) { return sub_patches.number(d, read); };
        const auto length = [&](std::size_t k) {
            return get([k](const PackedSubPatch& h) -> const double& { return h.row_length[k]; });
        };
        const V length_n = length(2);
        steep = hn::Mul(hn::Abs(step), length_n);
        const V way = hn::MulAdd(
            hn::Set(d, ray_rounding), hn::Abs(depth),
            hn::Add(hn::Load(d, rays.blur.data() + lane),
                    get([](const PackedSubPatch& h) -> const double& { return h.blur; })));
        // F and G are multiplied by the weight, and so is what moves them.
        const V weight = get([](const PackedSubPatch& h) -> const double& { return h.value[3]; });
        blur_ = hn::MulAdd(way, weight, way);
        blur_u = hn::Mul(blur_, hn::MulAdd(hn::Abs(p), length_n, length(0)));
        blur_v = hn::Mul(blur_, hn::MulAdd(hn::Abs(q), length_n, length(1)));
    }

    template <class SubPatches>
    void set_bounds(D d, const SubPatches& sub_patches) {
        const V pp = hn::Abs(p), qq = hn::Abs(q);
        const auto mixed = [&](auto bounds, std::size_t own, V turn, V at) {
            const auto entry = [&](std::size_t k) {
                return sub_patches.number(d, [bounds, k](const PackedSubPatch& h) -> const double& {
                    return (h.*bounds)[k];
                });
            };
            return hn::MulAdd(hn::Abs(at), entry(3), hn::MulAdd(turn, entry(2), entry(own)));
        };
        const auto larger = [&](auto bounds) {
            return hn::Max(mixed(bounds, 0, pp, a), mixed(bounds, 1, qq, b));
        };
        contraction = larger(&PackedSubPatch::slope);
        bend_ = larger(&PackedSubPatch::bend);
        strip_u_ = hn::Add(mixed(&PackedSubPatch::value, 0, pp, a), blur_u);
        strip_v_ = hn::Add(mixed(&PackedSubPatch::value, 1, qq, b), blur_v);
        const V height = sub_patches.number(
            d, [](const PackedSubPatch& h) -> const double& { return h.height; });
        reach_ = hn::MulAdd(hn::Abs(step), height, hn::Mul(blur_, steep));
    }

    V blur_, strip_u_, strip_v_, bend_, reach_;
};

/// TrimCells::Set, one a lane.
template <class D>
using CellSets = hn::Vec<hn::RebindToUnsigned<D>>;

/// Column or row of a cell, as TrimCells::met counts them.
template <class D>
CellSets<D> cell_index(D d, hn::Vec<D> place) {
    const auto scaled = hn::Mul(hn::Set(d, 4), hn::Add(place, hn::Set(d, 1)));
    const auto index = hn::Floor(hn::Min(hn::Max(scaled, hn::Zero(d)), hn::Set(d, 7)));
    // The lowest bits of a number so large are units.
    const auto number = hn::Add(index, hn::Set(d, 0x1p52));
    const hn::RebindToUnsigned<D> u;
    return hn::And(hn::BitCast(u, number), hn::Set(u, 7));
}

/// TrimCells::met for boxes about (x, y).
template <class D>
CellSets<D> cells_met(D d, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> off_x, hn::Vec<D> off_y) {
    const hn::RebindToUnsigned<D> u;
    const auto from_last = [&](CellSets<D> index) { return hn::Sub(hn::Set(u, 7), index); };
    const auto eightfold = [](CellSets<D> index) { return hn::ShiftLeft<3>(index); };
    const auto left = cell_index(d, hn::Sub(x, off_x)), right = cell_index(d, hn::Add(x, off_x));
    const auto bottom = cell_index(d, hn::Sub(y, off_y)), top = cell_index(d, hn::Add(y, off_y));
    const auto eight = hn::Set(u, 0xff), all = hn::Set(u, ~TrimCells::Set{0});
    auto row = hn::And(hn::Shr(eight, from_last(right)), hn::Shl(eight, left));
    row = hn::Or(row, hn::ShiftLeft<8>(row));
    row = hn::Or(row, hn::ShiftLeft<16>(row));
    row = hn::Or(row, hn::ShiftLeft<32>(row));
    return hn::And(
        row, hn::And(hn::Shr(all, eightfold(from_last(top))), hn::Shl(all, eightfold(bottom))));
}

/// The boxes that lie in cells of a set alone.
template <class D>
hn::Mask<D> lie_in(D d, CellSets<D> met, TrimCells::Set cells) {
    const hn::RebindToUnsigned<D> u;
    const auto beyond = hn::AndNot(hn::Set(u, cells), met);
    return hn::RebindMask(d, hn::Eq(beyond, hn::Zero(u)));
}

/// Beyond this the proofs' own rounding would matter.
constexpr double largest_contraction = 0.95;
/// 1 / cosine: rays lower over the sub-patch see a plane that is mostly rounding.
constexpr double steepest = 1e6;

/// Existence test (docs/theory/intersector.md#the-existence-test) for the rays of a vector that
/// begins at `lane`: adds their bits to the masks of `result`, those of lanes without a request
/// included.
template <class D>
void existence_test(D d, const RayPacket& rays, std::size_t lane, const PackedSubPatch& sub_patch,
                    ExistenceResult& result) {
    const RayPlanes<D> v(d, rays, lane, SameSubPatch{sub_patch, nullptr});
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
    auto single =
        hn::And(hn::And(left, sane), hn::Lt(v.contraction, hn::Set(d, largest_contraction)));
    const auto undecided = hn::AndNot(single, left);
    const auto within = [&](auto place, auto strip, std::size_t axis) {
        return hn::And(hn::Ge(hn::Sub(place, strip), hn::Set(d, sub_patch.patch_low[axis])),
                       hn::Le(hn::Add(place, strip), hn::Set(d, sub_patch.patch_high[axis])));
    };
    const auto inside = hn::And(within(v.a, v.strip_u(), 0), within(v.b, v.strip_v(), 1));
    const auto store = [&](auto from, RayPacket::Lanes<double>& to) {
        hn::Store(from, d, to.data() + lane);
    };
    store(near_s, result.nearest);
    store(far_s, result.farthest);
    const auto bits = [&](hn::Mask<D> mask) { return lane_bits(d, mask, lane); };
    if (sub_patch.material) {
        result.material |= bits(hn::And(single, inside));
    } else if (sub_patch.cells) {
        const auto met = cells_met(d, v.a, v.b, v.strip_u(), v.strip_v());
        single = hn::AndNot(lie_in(d, met, sub_patch.cells.empty), single);
        result.material |=
            bits(hn::And(hn::And(single, inside), lie_in(d, met, sub_patch.cells.material)));
    }
    result.certain |= bits(hn::And(single, inside));
    result.single |= bits(hn::AndNot(inside, single));
    result.undecided |= bits(undecided);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
