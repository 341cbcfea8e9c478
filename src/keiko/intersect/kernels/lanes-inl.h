// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_TRACE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_LANES_INL_H
#undef KEIKO_TRACE_LANES_INL_H
#else
#define KEIKO_TRACE_LANES_INL_H
#endif

#include "keiko/intersect/kernels/ray_packet.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Wide = hn::CappedTag<double, 8>; ///< As many lanes as the instruction set has, 8 at most.
using One = hn::CappedTag<double, 1>;  ///< A single lane.

/// A mask of a vector that begins at `lane`, by lanes of the block.
template <class D>
LaneMask lane_bits(D d, hn::Mask<D> mask, std::size_t lane) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return static_cast<LaneMask>(bits[0]) << lane;
}
/// Calls `work(first lane)` for each vector that has a lane in the mask.
template <class Work>
void for_vectors(LaneMask mask, const Work& work) {
    const std::size_t width = hn::Lanes(Wide());
    const LaneMask all = (LaneMask{1} << width) - 1;
    for (std::size_t lane = 0; lane < RayPacket::capacity; lane += width)
        if ((mask >> lane & all) != 0) work(lane);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
