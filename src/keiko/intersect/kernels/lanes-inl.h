// Compiled once for each instruction set by the kernels that include it.
#if defined(KEIKO_INTERSECT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_LANES_INL_H
#undef KEIKO_INTERSECT_LANES_INL_H
#else
#define KEIKO_INTERSECT_LANES_INL_H
#endif

#include "keiko/intersect/kernels/ray_packet.h"

#include <hwy/highway.h>

#include <array>

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

/// Vectors of space, one a lane; each operation as Vec3 does it, to the last bit.
template <class V>
using Space = std::array<V, 3>;

/// Each vector times its own factor.
template <class V>
Space<V> scaled(const Space<V>& a, V factor) {
    return {hn::Mul(a[0], factor), hn::Mul(a[1], factor), hn::Mul(a[2], factor)};
}
/// Each vector over its own divisor.
template <class V>
Space<V> divided(const Space<V>& a, V by) {
    return {hn::Div(a[0], by), hn::Div(a[1], by), hn::Div(a[2], by)};
}
/// a + b.
template <class V>
Space<V> sum(const Space<V>& a, const Space<V>& b) {
    return {hn::Add(a[0], b[0]), hn::Add(a[1], b[1]), hn::Add(a[2], b[2])};
}
/// a - b.
template <class V>
Space<V> difference(const Space<V>& a, const Space<V>& b) {
    return {hn::Sub(a[0], b[0]), hn::Sub(a[1], b[1]), hn::Sub(a[2], b[2])};
}
/// Dot product, without fused multiply-adds.
template <class V>
V product(const Space<V>& a, const Space<V>& b) {
    return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}
/// Squared length.
template <class V>
V square(const Space<V>& a) {
    return product(a, a);
}
/// Cross product a x b.
template <class V>
Space<V> cross(const Space<V>& a, const Space<V>& b) {
    const auto entry = [&](std::size_t i, std::size_t j) {
        return hn::Sub(hn::Mul(a[i], b[j]), hn::Mul(a[j], b[i]));
    };
    return {entry(1, 2), entry(2, 0), entry(0, 1)};
}

/// Vectors from the three coordinates' arrays, from a lane on.
template <class D, std::size_t size>
Space<hn::Vec<D>> load(D d, const std::array<std::array<double, size>, 3>& from, std::size_t lane) {
    return {hn::Load(d, from[0].data() + lane), hn::Load(d, from[1].data() + lane),
            hn::Load(d, from[2].data() + lane)};
}
/// Writes vectors into the three coordinates' arrays, from a lane on.
template <class D, std::size_t size>
void store(D d, const Space<hn::Vec<D>>& from, std::array<std::array<double, size>, 3>& to,
           std::size_t lane) {
    for (std::size_t k = 0; k < 3; ++k) hn::Store(from[k], d, to[k].data() + lane);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
