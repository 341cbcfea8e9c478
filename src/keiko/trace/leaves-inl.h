// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_LEAVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_LEAVES_INL_H
#undef KEIKO_TRACE_LEAVES_INL_H
#else
#define KEIKO_TRACE_LEAVES_INL_H
#endif

#include "keiko/trace/lanes-inl.h"
#include "keiko/trace/leaf_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// One leaf in all lanes.
struct SameLeaf {
    const HotLeaf& leaf;
    const Component4* polynomial;

    const HotLeaf& shape() const { return leaf; }
    /// The number that `read` takes from each lane's leaf.
    template <class D, class Read>
    hn::Vec<D> number(D d, const Read& read) const {
        return hn::Set(d, read(leaf));
    }
    template <class D>
    hn::Vec<D> coefficient(D d, std::size_t index, std::size_t component) const {
        return hn::Set(d, polynomial[index][component]);
    }
};

/// A leaf for each lane, all of the same degrees and all rational or none.
class GatheredLeaves {
public:
    static constexpr std::size_t lanes = hn::MaxLanes(Wide());

    /// `polynomials` is where coefficients of leaves begin.
    GatheredLeaves(const std::array<const HotLeaf*, lanes>& leaves, const Component4* polynomials)
        : leaves_(leaves) {
        const std::size_t count = shape().coefficients();
        const std::size_t used = shape().rational ? 4 : 3;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const Component4* from = polynomials + leaves[lane]->polynomial;
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < used; ++c) coefficients_[i][c][lane] = from[i][c];
        }
    }

    const HotLeaf& shape() const { return *leaves_[0]; }
    template <class D, class Read>
    hn::Vec<D> number(D d, const Read& read) const {
        alignas(64) std::array<double, lanes> numbers;
        for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
            numbers[lane] = read(*leaves_[lane]);
        return hn::Load(d, numbers.data());
    }
    template <class D>
    hn::Vec<D> coefficient(D d, std::size_t index, std::size_t component) const {
        return hn::Load(d, coefficients_[index][component].data());
    }

private:
    std::array<const HotLeaf*, lanes> leaves_;
    alignas(
        64) std::array<std::array<std::array<double, lanes>, 4>, largest_gathered> coefficients_;
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
