#include "keiko/intersect/kernels/leaf_kernels.h"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/intersect/kernels/leaf_kernels.cpp"
// First: it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then what is made for the one in hand.
#include "keiko/intersect/kernels/box_search-inl.h"
#include "keiko/intersect/kernels/hit_jets-inl.h"
#include "keiko/intersect/kernels/newton-inl.h"
#include "keiko/intersect/kernels/patch_jet-inl.h"
#include "keiko/intersect/kernels/ray_boxes-inl.h"
#include "keiko/intersect/kernels/ray_entry-inl.h"

// Every multiply-add of the kernels is MulAdd, fused on some targets only: the bounds hold both
// ways, since fusing only ever leaves a rounding out. Wide and single forms do the same steps in
// the same order, so that a ray gets the same bits in any company.

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

void look(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.material = result.single = result.undecided = 0;
    for_vectors(mask, [&](std::size_t lane) { look_at(Wide(), rays, lane, leaf, result); });
    result.certain &= mask;
    result.material &= mask;
    result.single &= mask;
    result.undecided &= mask;
}

void look_single(const RayBlock& rays, std::size_t lane, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.material = result.single = result.undecided = 0;
    look_at(One(), rays, lane, leaf, result);
}

void solve(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, const Component4* polynomial,
           LeafRoots& result) {
    solve_lanes(
        rays, mask,
        [&](std::size_t) {
            return SameLeaf{leaf, polynomial};
        },
        result);
}

void solve_single(const RayBlock& rays, std::size_t lane, const HotLeaf& leaf,
                  const Component4* polynomial, LeafRoots& result) {
    result.failed = 0;
    Newton<One, SameLeaf> one(rays, lane, LaneMask{1} << lane, {leaf, polynomial});
    result.found = solve_in_turns(result, one);
}

void solve_apart(const RayBlock& rays, LaneMask mask, const RayBlock::Lanes<const HotLeaf*>& leaves,
                 const Component4* polynomials, LeafRoots& result) {
    const auto leaves_at = [&](std::size_t lane) {
        const auto any = static_cast<std::size_t>(std::countr_zero(mask >> lane));
        std::array<const HotLeaf*, OwnLeaves::lanes> here;
        for (std::size_t i = 0; i < here.size(); ++i) {
            const bool wanted = lane + i < RayBlock::capacity && (mask >> (lane + i) & 1) != 0;
            here[i] = leaves[lane + (wanted ? i : any)];
        }
        return OwnLeaves(here, polynomials);
    };
    solve_lanes(rays, mask, leaves_at, result);
}

LeafKernels kernels() {
    return {hwy::TargetName(HWY_TARGET),
            enter,
            look,
            look_single,
            solve,
            solve_single,
            solve_apart,
            narrow,
            find_roots,
            evaluate,
            evaluate_hits};
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
