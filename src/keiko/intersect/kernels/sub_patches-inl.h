// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_SUB_PATCHES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_SUB_PATCHES_INL_H
#undef KEIKO_INTERSECT_SUB_PATCHES_INL_H
#else
#define KEIKO_INTERSECT_SUB_PATCHES_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

inline double degrees_of(const PackedSubPatch& sub_patch) {
    return static_cast<double>(sub_patch.degree_u) + static_cast<double>(sub_patch.degree_v);
}

/// One sub-patch in all lanes.
struct SameSubPatch {
    const PackedSubPatch& sub_patch;
    const Component4* polynomial;

    const PackedSubPatch& shape() const { return sub_patch; }
    bool rational() const { return sub_patch.rational; }
    /// The number of each lane's sub-patch that `find` finds there.
    template <class D, class Find>
    hn::Vec<D> number(D d, const Find& find) const {
        return hn::Set(d, find(sub_patch));
    }
    template <class D>
    hn::Vec<D> degrees(D d) const {
        return hn::Set(d, degrees_of(sub_patch));
    }
    template <class D>
    hn::Vec<D> coefficient(D d, std::size_t index, std::size_t component) const {
        return hn::Set(d, polynomial[index][component]);
    }
};

/// A sub-patch for each lane; all of one array.
class OwnSubPatches {
public:
    static constexpr std::size_t lanes = hn::MaxLanes(Wide());

    /// `polynomials` is where coefficients of sub-patches begin.
    OwnSubPatches(const std::array<const PackedSubPatch*, lanes>& sub_patches,
                  const Component4* polynomials)
        : sub_patches_(sub_patches), polynomials_(polynomials) {
        static_assert(sizeof(PackedSubPatch) % sizeof(double) == 0);
        constexpr std::ptrdiff_t size = sizeof(PackedSubPatch) / sizeof(double);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            places_[lane] = (sub_patches[lane] - sub_patches[0]) * size;
            degrees_[lane] = degrees_of(*sub_patches[lane]);
            rational_ = rational_ || sub_patches[lane]->rational;
        }
    }

    bool rational() const { return rational_; }
    const PackedSubPatch& sub_patch(std::size_t lane) const { return *sub_patches_[lane]; }
    const Component4* polynomial(std::size_t lane) const {
        return polynomials_ + sub_patches_[lane]->polynomial;
    }
    template <class D, class Find>
    hn::Vec<D> number(D d, const Find& find) const {
        const double& first = find(*sub_patches_[0]);
        return hn::GatherIndex(d, &first, hn::Load(hn::RebindToSigned<D>(), places_.data()));
    }
    template <class D>
    hn::Vec<D> degrees(D d) const {
        return hn::Load(d, degrees_.data());
    }

private:
    std::array<const PackedSubPatch*, lanes> sub_patches_;
    const Component4* polynomials_;
    bool rational_ = false; ///< any of them
    /// In numbers, behind the first sub-patch.
    alignas(64) std::array<std::int64_t, lanes> places_;
    alignas(64) std::array<double, lanes> degrees_;
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
