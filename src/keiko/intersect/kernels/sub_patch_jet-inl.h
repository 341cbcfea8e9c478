// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_SUB_PATCH_JET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_SUB_PATCH_JET_INL_H
#undef KEIKO_INTERSECT_SUB_PATCH_JET_INL_H
#else
#define KEIKO_INTERSECT_SUB_PATCH_JET_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"

#include <bit>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Sum of the two degrees.
inline double degrees_of(const PackedSubPatch& sub_patch) {
    return static_cast<double>(sub_patch.degree_u) + static_cast<double>(sub_patch.degree_v);
}

/// One sub-patch in all lanes.
struct SameSubPatch {
    const PackedSubPatch& sub_patch; ///< the one
    const Component4* polynomial;    ///< its own coefficients; null where none are read

    const PackedSubPatch& shape() const { return sub_patch; } ///< The sub-patch.
    bool rational() const { return sub_patch.rational; }      ///< True if its weights differ.
    /// The number of each lane's sub-patch that `find` finds there.
    template <class D, class Find>
    hn::Vec<D> number(D d, const Find& find) const {
        return hn::Set(d, find(sub_patch));
    }
    /// Sum of the two degrees, in all lanes.
    template <class D>
    hn::Vec<D> degrees(D d) const {
        return hn::Set(d, degrees_of(sub_patch));
    }
    /// One component of one coefficient, in all lanes.
    template <class D>
    hn::Vec<D> coefficient(D d, std::size_t index, std::size_t component) const {
        return hn::Set(d, polynomial[index][component]);
    }
};

/// A sub-patch for each lane; all of one array.
class OwnSubPatches {
public:
    static constexpr std::size_t lanes = hn::MaxLanes(Wide()); ///< of a vector
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

    bool rational() const { return rational_; } ///< True if the weights of any of them differ.
    /// Sub-patch of a lane.
    const PackedSubPatch& sub_patch(std::size_t lane) const { return *sub_patches_[lane]; }
    /// Coefficients of a lane's sub-patch.
    const Component4* polynomial(std::size_t lane) const {
        return polynomials_ + sub_patches_[lane]->polynomial;
    }
    /// The number of each lane's sub-patch that `find` returns a reference to.
    template <class D, class Find>
    hn::Vec<D> number(D d, const Find& find) const {
        const double& first = find(*sub_patches_[0]);
        return hn::GatherIndex(d, &first, hn::Load(hn::RebindToSigned<D>(), places_.data()));
    }
    /// Sum of the two degrees of each lane's sub-patch.
    template <class D>
    hn::Vec<D> degrees(D d) const {
        return hn::Load(d, degrees_.data());
    }

private:
    /// In numbers, behind the first sub-patch.
    alignas(64) std::array<std::int64_t, lanes> places_;
    alignas(64) std::array<double, lanes> degrees_;
    std::array<const PackedSubPatch*, lanes> sub_patches_;
    const Component4* polynomials_;
    bool rational_ = false; ///< any of them
};

/// Value and first derivatives of the components at (x, y).
template <class V>
struct Jet {
    std::array<V, 4> value;      ///< (w X, w Y, w Z, w)
    std::array<V, 4> by_x, by_y; ///< derivatives of `value`
};

/// Calls `work` with the number of columns of a sub-patch's coefficients as a constant, or 0 for
/// many: loops over them are unrolled.
template <class Work>
auto with_columns(const PackedSubPatch& sub_patch, const Work& work) {
    switch (sub_patch.degree_v) {
        case 1:
            return work(std::integral_constant<std::size_t, 2>());
        case 2:
            return work(std::integral_constant<std::size_t, 3>());
        case 3:
            return work(std::integral_constant<std::size_t, 4>());
        case 4:
            return work(std::integral_constant<std::size_t, 5>());
        case 5:
            return work(std::integral_constant<std::size_t, 6>());
        case 6:
            return work(std::integral_constant<std::size_t, 7>());
        case 7:
            return work(std::integral_constant<std::size_t, 8>());
        default:
            return work(std::integral_constant<std::size_t, 0>());
    }
}

/// Jet of a sub-patch at a place a lane, without the weight's entries if not `rational`.
/// `known_columns` is degree_v + 1, or 0 to read it from the sub-patch.
template <bool rational, std::size_t known_columns, class D>
Jet<hn::Vec<D>> jet(D d, const SameSubPatch& sub_patches, hn::Vec<D> x, hn::Vec<D> y) {
    using V = hn::Vec<D>;
    constexpr std::size_t used = rational ? 4 : 3;
    const std::size_t columns = known_columns ? known_columns : sub_patches.shape().degree_v + 1u;
    const std::size_t last = sub_patches.shape().degree_u;
    Jet<V> jet;
    for (std::size_t i = last + 1; i-- > 0;) {
        std::array<V, used> value, slope;
        const auto at = [&](std::size_t j, std::size_t c) {
            return sub_patches.coefficient(d, i * columns + j, c);
        };
        for (std::size_t c = 0; c < used; ++c) {
            slope[c] = at(columns - 1, c);
            value[c] = hn::MulAdd(slope[c], y, at(columns - 2, c));
        }
        for (std::size_t j = columns - 2; j-- > 0;)
            for (std::size_t c = 0; c < used; ++c) {
                slope[c] = hn::MulAdd(slope[c], y, value[c]);
                value[c] = hn::MulAdd(value[c], y, at(j, c));
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

/// Jets of some rays, for each the components side by side.
template <std::size_t count>
struct JetsByRay {
    using Components = std::array<Component4, count>; ///< Four components of each ray.
    alignas(64) Components value;                     ///< (w X, w Y, w Z, w)
    alignas(64) Components by_x;                      ///< derivatives of `value`
    alignas(64) Components by_y;                      ///< derivatives of `value`

    /// Finds the jet of one ray at a place of its sub-patch, whose own coefficients are given.
    void find(std::size_t ray, const PackedSubPatch& sub_patch, const Component4* polynomial,
              double at_x, double at_y) {
        with_columns(sub_patch, [&](auto columns) {
            find_known<columns>(ray, sub_patch, polynomial, at_x, at_y);
        });
    }

private:
    template <std::size_t known_columns>
    void find_known(std::size_t ray, const PackedSubPatch& sub_patch, const Component4* polynomial,
                    double at_x, double at_y) {
        const hn::CappedTag<double, 4> d;
        const std::size_t columns = known_columns ? known_columns : sub_patch.degree_v + 1u;
        const auto x = hn::Set(d, at_x), y = hn::Set(d, at_y);
        for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
            auto total = hn::Zero(d), total_x = hn::Zero(d), total_y = hn::Zero(d);
            for (std::size_t i = sub_patch.degree_u + 1u; i-- > 0;) {
                const Component4* row = polynomial + i * columns;
                auto slope = hn::LoadU(d, row[columns - 1].data() + c);
                auto here = hn::MulAdd(slope, y, hn::LoadU(d, row[columns - 2].data() + c));
                for (std::size_t j = columns - 2; j-- > 0;) {
                    slope = hn::MulAdd(slope, y, here);
                    here = hn::MulAdd(here, y, hn::LoadU(d, row[j].data() + c));
                }
                total_x = hn::MulAdd(total_x, x, total);
                total = hn::MulAdd(total, x, here);
                total_y = hn::MulAdd(total_y, x, slope);
            }
            hn::Store(total, d, value[ray].data() + c);
            hn::Store(total_x, d, by_x[ray].data() + c);
            hn::Store(total_y, d, by_y[ray].data() + c);
        }
    }
};

/// Jets of all lanes.
template <class D>
Jet<hn::Vec<D>> jet_of(D d, const SameSubPatch& sub_patch, hn::Vec<D> x, hn::Vec<D> y) {
    return with_columns(sub_patch.shape(), [&](auto columns) {
        if (sub_patch.rational()) return jet<true, columns>(d, sub_patch, x, y);
        Jet<hn::Vec<D>> result = jet<false, columns>(d, sub_patch, x, y);
        result.value[3] = hn::Set(d, 1);
        result.by_x[3] = result.by_y[3] = hn::Zero(d);
        return result;
    });
}

inline Jet<hn::Vec<One>> jet_of(One d, const SameSubPatch& sub_patch, hn::Vec<One> x,
                                hn::Vec<One> y) {
    JetsByRay<1> one;
    one.find(0, sub_patch.sub_patch, sub_patch.polynomial, hn::GetLane(x), hn::GetLane(y));
    Jet<hn::Vec<One>> result;
    for (std::size_t c = 0; c < 4; ++c) {
        result.value[c] = hn::Set(d, one.value[0][c]);
        result.by_x[c] = hn::Set(d, one.by_x[0][c]);
        result.by_y[c] = hn::Set(d, one.by_y[0][c]);
    }
    return result;
}

/// Jets of the lanes of a mask; anything in the others.
template <class D>
Jet<hn::Vec<D>> jet_of(D d, const SameSubPatch& sub_patch, hn::Mask<D>, hn::Vec<D> x,
                       hn::Vec<D> y) {
    return jet_of(d, sub_patch, x, y);
}

/// Jets of some lanes one after the other; `find(lane, x, y, jets)` finds each.
template <class Find>
Jet<hn::Vec<Wide>> jets_in_turn(Wide d, LaneMask wanted, hn::Vec<Wide> x, hn::Vec<Wide> y,
                                const Find& find) {
    alignas(64) std::array<double, OwnSubPatches::lanes> at_x, at_y;
    hn::Store(x, d, at_x.data());
    hn::Store(y, d, at_y.data());
    JetsByRay<OwnSubPatches::lanes> jets{};
    for (LaneMask left = wanted; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        find(lane, at_x[lane], at_y[lane], jets);
    }
    Jet<hn::Vec<Wide>> result;
    const auto load = [&](const auto& from, auto& to) {
        hn::LoadInterleaved4(d, from.front().data(), to[0], to[1], to[2], to[3]);
    };
    load(jets.value, result.value);
    load(jets.by_x, result.by_x);
    load(jets.by_y, result.by_y);
    return result;
}

inline Jet<hn::Vec<Wide>> jet_of(Wide d, const OwnSubPatches& sub_patches, hn::Mask<Wide> wanted,
                                 hn::Vec<Wide> x, hn::Vec<Wide> y) {
    const auto find = [&](std::size_t lane, double at_x, double at_y, auto& jets) {
        jets.find(lane, sub_patches.sub_patch(lane), sub_patches.polynomial(lane), at_x, at_y);
    };
    return jets_in_turn(d, lane_bits(d, wanted, 0), x, y, find);
}

/// Jets of the first lanes; anything in the others. A few are found sooner one by one.
inline Jet<hn::Vec<Wide>> jet_of_first(Wide d, const SameSubPatch& sub_patch, std::size_t count,
                                       hn::Vec<Wide> x, hn::Vec<Wide> y) {
    if (4 * count > hn::Lanes(d)) return jet_of(d, sub_patch, x, y);
    const auto find = [&](std::size_t lane, double at_x, double at_y, auto& jets) {
        jets.find(lane, sub_patch.sub_patch, sub_patch.polynomial, at_x, at_y);
    };
    return jets_in_turn(d, (LaneMask{1} << count) - 1, x, y, find);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
