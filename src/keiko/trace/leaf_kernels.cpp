#include "keiko/trace/leaf_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/trace/leaf_kernels.cpp"
// First: it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then what is made for the one in hand.
#include "keiko/trace/krawczyk-inl.h"
#include "keiko/trace/newton-inl.h"
#include "keiko/trace/patch_jet-inl.h"
#include "keiko/trace/ray_entry-inl.h"

// Every multiply-add of the kernels is MulAdd, fused on some targets only: the bounds hold both
// ways, since fusing only ever leaves a rounding out. Wide and single forms do the same steps in
// the same order, so that a ray gets the same bits in any company.

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

void look(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.single = result.undecided = 0;
    for_vectors(mask, [&](std::size_t lane) { look_at(Wide(), rays, lane, leaf, result); });
    result.certain &= mask;
    result.single &= mask;
    result.undecided &= mask;
}

void look_single(const RayBlock& rays, std::size_t lane, const HotLeaf& leaf, LeafLook& result) {
    result.certain = result.single = result.undecided = 0;
    look_at(One(), rays, lane, leaf, result);
}

void solve(const RayBlock& rays, LaneMask mask, const HotLeaf& leaf, const Component4* polynomial,
           LeafRoots& result) {
    result.found = result.failed = 0;
    for_vectors(mask, [&](std::size_t lane) {
        result.found |= solve_lanes(Wide(), rays, lane, mask, leaf, polynomial, result);
    });
}

void solve_single(const RayBlock& rays, std::size_t lane, const HotLeaf& leaf,
                  const Component4* polynomial, LeafRoots& result) {
    result.found = result.failed = 0;
    result.found = solve_lanes(One(), rays, lane, LaneMask{1} << lane, leaf, polynomial, result);
}

LeafKernels kernels() {
    return {hwy::TargetName(HWY_TARGET),
            enter,
            look,
            look_single,
            solve,
            solve_single,
            find_roots,
            evaluate};
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
