// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_LEAF_JET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_LEAF_JET_INL_H
#undef KEIKO_TRACE_LEAF_JET_INL_H
#else
#define KEIKO_TRACE_LEAF_JET_INL_H
#endif

#include "keiko/trace/leaves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Value and first derivatives of the components at (x, y).
template <class V>
struct Jet {
    std::array<V, 4> value, by_x, by_y;
};

template <bool rational, class D, class Leaves>
Jet<hn::Vec<D>> jet(D d, const Leaves& leaves, hn::Vec<D> x, hn::Vec<D> y) {
    using V = hn::Vec<D>;
    constexpr std::size_t used = rational ? 4 : 3;
    const std::size_t columns = leaves.shape().degree_v + 1u, last = leaves.shape().degree_u;
    Jet<V> jet;
    for (std::size_t i = last + 1; i-- > 0;) {
        std::array<V, used> value, slope;
        for (std::size_t c = 0; c < used; ++c) {
            value[c] = leaves.coefficient(d, i * columns + columns - 1, c);
            slope[c] = hn::Zero(d);
        }
        for (std::size_t j = columns - 1; j-- > 0;)
            for (std::size_t c = 0; c < used; ++c) {
                slope[c] = hn::MulAdd(slope[c], y, value[c]);
                value[c] = hn::MulAdd(value[c], y, leaves.coefficient(d, i * columns + j, c));
            }
        for (std::size_t c = 0; c < used; ++c) {
            if (i == last) {
                jet.by_x[c] = hn::Zero(d);
                jet.value[c] = value[c];
                jet.by_y[c] = slope[c];
            } else {
                jet.by_x[c] = hn::MulAdd(jet.by_x[c], x, jet.value[c]);
                jet.value[c] = hn::MulAdd(jet.value[c], x, value[c]);
                jet.by_y[c] = hn::MulAdd(jet.by_y[c], x, slope[c]);
            }
        }
    }
    return jet;
}

/// The same for one ray, the components side by side.
struct SingleJet {
    alignas(32) std::array<double, 4> value, by_x, by_y;
};

inline SingleJet single_jet(const HotLeaf& leaf, const Component4* polynomial, double at_x,
                            double at_y) {
    const hn::CappedTag<double, 4> d;
    const std::size_t columns = leaf.degree_v + 1u;
    const auto x = hn::Set(d, at_x), y = hn::Set(d, at_y);
    SingleJet jet;
    for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
        auto total = hn::Zero(d), by_x = hn::Zero(d), by_y = hn::Zero(d);
        for (std::size_t i = leaf.degree_u + 1u; i-- > 0;) {
            const Component4* row = polynomial + i * columns;
            auto value = hn::LoadU(d, row[columns - 1].data() + c), slope = hn::Zero(d);
            for (std::size_t j = columns - 1; j-- > 0;) {
                slope = hn::MulAdd(slope, y, value);
                value = hn::MulAdd(value, y, hn::LoadU(d, row[j].data() + c));
            }
            by_x = hn::MulAdd(by_x, x, total);
            total = hn::MulAdd(total, x, value);
            by_y = hn::MulAdd(by_y, x, slope);
        }
        hn::Store(total, d, jet.value.data() + c);
        hn::Store(by_x, d, jet.by_x.data() + c);
        hn::Store(by_y, d, jet.by_y.data() + c);
    }
    return jet;
}

/// Jets of all lanes.
template <class D, class Leaves>
Jet<hn::Vec<D>> jet_of(D d, const Leaves& leaves, hn::Vec<D> x, hn::Vec<D> y) {
    if (leaves.shape().rational) return jet<true>(d, leaves, x, y);
    Jet<hn::Vec<D>> result = jet<false>(d, leaves, x, y);
    result.value[3] = hn::Set(d, 1);
    result.by_x[3] = result.by_y[3] = hn::Zero(d);
    return result;
}

inline Jet<hn::Vec<One>> jet_of(One d, const SameLeaf& leaves, hn::Vec<One> x, hn::Vec<One> y) {
    const SingleJet one =
        single_jet(leaves.leaf, leaves.polynomial, hn::GetLane(x), hn::GetLane(y));
    Jet<hn::Vec<One>> result;
    for (std::size_t c = 0; c < 4; ++c) {
        result.value[c] = hn::Set(d, one.value[c]);
        result.by_x[c] = hn::Set(d, one.by_x[c]);
        result.by_y[c] = hn::Set(d, one.by_y[c]);
    }
    return result;
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
