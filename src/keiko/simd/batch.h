#pragma once

// For files that are compiled once for each instruction set: see keiko_kernels() in
// src/cmake/kernels.cmake. KEIKO_LEVEL is the namespace of the set, so that no two sets share a
// symbol.

#include "keiko/simd/real.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

namespace keiko::KEIKO_LEVEL {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<double, 8>; ///< As many lanes as the instruction set has, 8 at most.

/// Number of doubles in a batch.
constexpr std::size_t lanes = hn::MaxLanes(Lanes());

/// A bool a lane.
class Mask {
public:
    Mask() = default;
    /// One value for all lanes.
    Mask(bool all) : lanes_(hn::FirstN(Lanes(), all ? lanes : 0)) {}
    /// Lanes of a vector's mask.
    explicit Mask(hn::Mask<Lanes> mask) : lanes_(mask) {}
    /// The vector's mask.
    hn::Mask<Lanes> vector() const { return lanes_; }

private:
    hn::Mask<Lanes> lanes_;
};

/// True where both are.
inline Mask operator&&(Mask a, Mask b) {
    return Mask(hn::And(a.vector(), b.vector()));
}
/// True where either is.
inline Mask operator||(Mask a, Mask b) {
    return Mask(hn::Or(a.vector(), b.vector()));
}
/// True where the mask is not.
inline Mask operator!(Mask a) {
    return Mask(hn::Not(a.vector()));
}
/// True if the mask holds in any lane.
inline bool any_of(Mask a) {
    return !hn::AllFalse(Lanes(), a.vector());
}
/// The lanes as bits, the first the lowest.
inline std::uint32_t bits_of(Mask a) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Lanes(), a.vector(), bits);
    return bits[0];
}

/// Doubles side by side, each as if it were alone: products and sums are rounded one by one.
class Batch {
public:
    Batch() = default;
    /// One number for all lanes.
    Batch(double x) : lanes_(hn::Set(Lanes(), x)) {}
    /// Numbers of a vector.
    explicit Batch(hn::Vec<Lanes> vector) : lanes_(vector) {}
    /// Numbers from a place of the memory on, wherever it begins.
    static Batch load(const double* from) { return Batch(hn::LoadU(Lanes(), from)); }
    /// 0, 1, 2 and so on.
    static Batch count() { return Batch(hn::Iota(Lanes(), 0)); }
    /// Writes the numbers to a place of the memory, wherever it begins.
    void store(double* to) const { hn::StoreU(lanes_, Lanes(), to); }
    /// The vector.
    hn::Vec<Lanes> vector() const { return lanes_; }

    Batch operator-() const { return Batch(hn::Neg(lanes_)); }
    Batch& operator+=(Batch b) { return *this = Batch(hn::Add(lanes_, b.lanes_)); }

    friend Batch operator+(Batch a, Batch b) { return Batch(hn::Add(a.lanes_, b.lanes_)); }
    friend Batch operator-(Batch a, Batch b) { return Batch(hn::Sub(a.lanes_, b.lanes_)); }
    friend Batch operator*(Batch a, Batch b) { return Batch(hn::Mul(a.lanes_, b.lanes_)); }
    friend Batch operator/(Batch a, Batch b) { return Batch(hn::Div(a.lanes_, b.lanes_)); }
    friend Mask operator<(Batch a, Batch b) { return Mask(hn::Lt(a.lanes_, b.lanes_)); }
    friend Mask operator>(Batch a, Batch b) { return Mask(hn::Gt(a.lanes_, b.lanes_)); }
    friend Mask operator<=(Batch a, Batch b) { return Mask(hn::Le(a.lanes_, b.lanes_)); }
    friend Mask operator>=(Batch a, Batch b) { return Mask(hn::Ge(a.lanes_, b.lanes_)); }
    friend Mask operator==(Batch a, Batch b) { return Mask(hn::Eq(a.lanes_, b.lanes_)); }

private:
    hn::Vec<Lanes> lanes_;
};

/// `a` where the mask holds, `b` elsewhere.
inline Batch select(Mask mask, Batch a, Batch b) {
    return Batch(hn::IfThenElse(mask.vector(), a.vector(), b.vector()));
}
// Elsewhere Highway's minimum and maximum prefer numbers to NaN.
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// The lesser numbers; the second where either is NaN.
inline Batch min(Batch a, Batch b) {
    return Batch(hn::Min(a.vector(), b.vector()));
}
/// The greater numbers; the second where either is NaN.
inline Batch max(Batch a, Batch b) {
    return Batch(hn::Max(a.vector(), b.vector()));
}
#else
inline Batch min(Batch a, Batch b) {
    return select(a < b, a, b);
}
inline Batch max(Batch a, Batch b) {
    return select(a > b, a, b);
}
#endif
/// Absolute values.
inline Batch abs(Batch x) {
    return Batch(hn::Abs(x.vector()));
}
/// Square roots.
inline Batch sqrt(Batch x) {
    return Batch(hn::Sqrt(x.vector()));
}
// Highway's vectors of one lane lose the sign of zero.
#if HWY_TARGET == HWY_SCALAR
inline Batch floor(Batch x) {
    return keiko::floor(hn::GetLane(x.vector()));
}
inline Batch ceil(Batch x) {
    return keiko::ceil(hn::GetLane(x.vector()));
}
#else
/// Largest integers that are not greater.
inline Batch floor(Batch x) {
    return Batch(hn::Floor(x.vector()));
}
/// Least integers that are not less.
inline Batch ceil(Batch x) {
    return Batch(hn::Ceil(x.vector()));
}
#endif
/// Sizes of the first numbers with the signs of the second.
inline Batch copysign(Batch size, Batch sign) {
    return Batch(hn::CopySign(size.vector(), sign.vector()));
}
/// False for NaN and infinite numbers.
inline Mask is_finite(Batch x) {
    return Mask(hn::IsFinite(x.vector()));
}

} // namespace keiko::KEIKO_LEVEL
