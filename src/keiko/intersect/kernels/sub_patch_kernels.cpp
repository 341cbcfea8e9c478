#include "keiko/intersect/kernels/sub_patch_kernels.h"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/intersect/kernels/sub_patch_kernels.cpp"
// First: it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then what is made for the one in hand.
#include "keiko/intersect/kernels/existence_test-inl.h"
#include "keiko/intersect/kernels/hit_derivatives-inl.h"
#include "keiko/intersect/kernels/krawczyk-inl.h"
#include "keiko/intersect/kernels/newton-inl.h"
#include "keiko/intersect/kernels/patch_jet-inl.h"
#include "keiko/intersect/kernels/ray_entry-inl.h"
#include "keiko/intersect/kernels/subdivision_search-inl.h"

// Every multiply-add of the kernels is MulAdd, fused on some targets only: the bounds hold both
// ways, since fusing only ever leaves a rounding out. Wide and single forms do the same steps in
// the same order, so that a ray gets the same bits in any company.

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

void existence_test(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch,
                    ExistenceResult& result) {
    result.certain = result.material = result.single = result.undecided = 0;
    for_vectors(mask,
                [&](std::size_t lane) { existence_test(Wide(), rays, lane, sub_patch, result); });
    result.certain &= mask;
    result.material &= mask;
    result.single &= mask;
    result.undecided &= mask;
}

void existence_test_single(const RayPacket& rays, std::size_t lane, const PackedSubPatch& sub_patch,
                           ExistenceResult& result) {
    result.certain = result.material = result.single = result.undecided = 0;
    existence_test(One(), rays, lane, sub_patch, result);
}

void solve(const RayPacket& rays, LaneMask mask, const PackedSubPatch& sub_patch,
           const Component4* polynomial, SubPatchRoots& result) {
    solve_lanes(
        rays, mask,
        [&](std::size_t) {
            return SameSubPatch{sub_patch, polynomial};
        },
        result);
}

void solve_single(const RayPacket& rays, std::size_t lane, const PackedSubPatch& sub_patch,
                  const Component4* polynomial, SubPatchRoots& result) {
    result.failed = 0;
    Newton<One, SameSubPatch> one(rays, lane, LaneMask{1} << lane, {sub_patch, polynomial});
    result.found = solve_in_turns(result, one);
}

void solve_apart(const RayPacket& rays, LaneMask mask,
                 const RayPacket::Lanes<const PackedSubPatch*>& sub_patches,
                 const Component4* polynomials, SubPatchRoots& result) {
    const auto sub_patches_at = [&](std::size_t lane) {
        const auto any = static_cast<std::size_t>(std::countr_zero(mask >> lane));
        std::array<const PackedSubPatch*, OwnSubPatches::lanes> here;
        for (std::size_t i = 0; i < here.size(); ++i) {
            const bool wanted = lane + i < RayPacket::capacity && (mask >> (lane + i) & 1) != 0;
            here[i] = sub_patches[lane + (wanted ? i : any)];
        }
        return OwnSubPatches(here, polynomials);
    };
    solve_lanes(rays, mask, sub_patches_at, result);
}

SubPatchKernels kernels() {
    return {hwy::TargetName(HWY_TARGET),
            enter,
            existence_test,
            existence_test_single,
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

SubPatchKernels sub_patch_kernels() {
    return HWY_DYNAMIC_DISPATCH(kernels)();
}

} // namespace keiko
#endif
