// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_LEAVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_LEAVES_INL_H
#undef KEIKO_TRACE_LEAVES_INL_H
#else
#define KEIKO_TRACE_LEAVES_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/leaf_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

inline double degrees_of(const HotLeaf& leaf) {
    return static_cast<double>(leaf.degree_u) + static_cast<double>(leaf.degree_v);
}

/// One leaf in all lanes.
struct SameLeaf {
    const HotLeaf& leaf;
    const Component4* polynomial;

    const HotLeaf& shape() const { return leaf; }
    bool rational() const { return leaf.rational; }
    /// The number of each lane's leaf that `find` finds there.
    template <class D, class Find>
    hn::Vec<D> number(D d, const Find& find) const {
        return hn::Set(d, find(leaf));
    }
    template <class D>
    hn::Vec<D> degrees(D d) const {
        return hn::Set(d, degrees_of(leaf));
    }
    template <class D>
    hn::Vec<D> coefficient(D d, std::size_t index, std::size_t component) const {
        return hn::Set(d, polynomial[index][component]);
    }
};

/// A leaf for each lane; all of one array.
class OwnLeaves {
public:
    static constexpr std::size_t lanes = hn::MaxLanes(Wide());

    /// `polynomials` is where coefficients of leaves begin.
    OwnLeaves(const std::array<const HotLeaf*, lanes>& leaves, const Component4* polynomials)
        : leaves_(leaves), polynomials_(polynomials) {
        static_assert(sizeof(HotLeaf) % sizeof(double) == 0);
        constexpr std::ptrdiff_t size = sizeof(HotLeaf) / sizeof(double);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            places_[lane] = (leaves[lane] - leaves[0]) * size;
            degrees_[lane] = degrees_of(*leaves[lane]);
            rational_ = rational_ || leaves[lane]->rational;
        }
    }

    bool rational() const { return rational_; }
    const HotLeaf& leaf(std::size_t lane) const { return *leaves_[lane]; }
    const Component4* polynomial(std::size_t lane) const {
        return polynomials_ + leaves_[lane]->polynomial;
    }
    template <class D, class Find>
    hn::Vec<D> number(D d, const Find& find) const {
        const double& first = find(*leaves_[0]);
        return hn::GatherIndex(d, &first, hn::Load(hn::RebindToSigned<D>(), places_.data()));
    }
    template <class D>
    hn::Vec<D> degrees(D d) const {
        return hn::Load(d, degrees_.data());
    }

private:
    std::array<const HotLeaf*, lanes> leaves_;
    const Component4* polynomials_;
    bool rational_ = false; ///< any of them
    /// In numbers, behind the first leaf.
    alignas(64) std::array<std::int64_t, lanes> places_;
    alignas(64) std::array<double, lanes> degrees_;
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
