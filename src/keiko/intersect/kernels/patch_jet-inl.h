// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_PATCH_JET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_PATCH_JET_INL_H
#undef KEIKO_INTERSECT_PATCH_JET_INL_H
#else
#define KEIKO_INTERSECT_PATCH_JET_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Bernstein polynomials of one degree and their first two derivatives, for a vector of places.
template <class D>
class BasisJet {
    using V = hn::Vec<D>;

public:
    static constexpr std::size_t lanes = hn::MaxLanes(D()); ///< places side by side
    /// One number of each place for each polynomial of a degree.
    using Row = std::array<std::array<double, lanes>, max_degree + 1>;

    alignas(64) Row value;  ///< polynomials, from the first to that of the degree
    alignas(64) Row first;  ///< first derivatives
    alignas(64) Row second; ///< second derivatives

    /// Polynomials at the places `t`. Requires a degree of at least 1.
    BasisJet(std::size_t degree, V t) : t_(t), rest_(hn::Sub(hn::Set(d_, 1), t)) {
        put(value, 0, hn::Set(d_, 1));
        std::size_t n = 0;
        while (n + 2 < degree) raise_degree(++n);
        // The row of degree n becomes the second derivative, the next one the first.
        if (n + 2 == degree) {
            difference_twice(n, static_cast<double>(degree * (degree - 1)));
            raise_degree(++n);
        } else {
            put(second, 0, hn::Zero(d_));
            put(second, 1, hn::Zero(d_));
        }
        const V factor = hn::Set(d_, static_cast<double>(degree));
        put(first, 0, hn::Mul(hn::Neg(factor), get(value, 0)));
        for (std::size_t i = 1; i < degree; ++i)
            put(first, i, hn::Mul(factor, hn::Sub(get(value, i - 1), get(value, i))));
        put(first, degree, hn::Mul(factor, get(value, degree - 1)));
        raise_degree(degree);
    }

private:
    V get(const Row& row, std::size_t i) const { return hn::Load(d_, row[i].data()); }
    void put(Row& row, std::size_t i, V v) { hn::Store(v, d_, row[i].data()); }

    /// From degree n - 1 to n.
    void raise_degree(std::size_t n) {
        V before = hn::Zero(d_);
        for (std::size_t i = 0; i < n; ++i) {
            const V here = get(value, i);
            const V kept = hn::Mul(rest_, here);
            put(value, i, i == 0 ? kept : hn::Add(kept, hn::Mul(t_, before)));
            before = here;
        }
        put(value, n, hn::Mul(t_, before));
    }
    void difference_twice(std::size_t n, double factor) {
        V before = hn::Zero(d_), first_of_two = before;
        for (std::size_t i = 0; i <= n + 2; ++i) {
            const V here = i <= n ? get(value, i) : hn::Zero(d_);
            const V twice = hn::Mul(hn::Set(d_, 2), before);
            put(second, i,
                hn::Mul(hn::Set(d_, factor), hn::Add(hn::Sub(here, twice), first_of_two)));
            first_of_two = before;
            before = here;
        }
    }

    static constexpr D d_{};
    V t_, rest_;
};

/// The surface at the place of one lane of the bases, the components side by side.
template <class D>
HomogeneousJet jet_at(const BezierPatchView& patch, const BasisJet<D>& u, const BasisJet<D>& v,
                      std::size_t lane) {
    const hn::CappedTag<double, 4> d;
    const auto rows = static_cast<std::size_t>(patch.degree_u);
    const auto columns = static_cast<std::size_t>(patch.degree_v);
    HomogeneousJet jet;
    for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
        auto value = hn::Zero(d), du = value, dv = value, duu = value, duv = value, dvv = value;
        const Vec4* point = patch.points.data();
        for (std::size_t i = 0; i <= rows; ++i) {
            auto row = hn::Zero(d), slope = row, bend = row;
            for (std::size_t j = 0; j <= columns; ++j, ++point) {
                const auto p = hn::LoadU(d, &point->x + c);
                row = hn::MulAdd(p, hn::Set(d, v.value[j][lane]), row);
                slope = hn::MulAdd(p, hn::Set(d, v.first[j][lane]), slope);
                bend = hn::MulAdd(p, hn::Set(d, v.second[j][lane]), bend);
            }
            const auto b = hn::Set(d, u.value[i][lane]), b1 = hn::Set(d, u.first[i][lane]);
            value = hn::MulAdd(row, b, value);
            dv = hn::MulAdd(slope, b, dv);
            dvv = hn::MulAdd(bend, b, dvv);
            du = hn::MulAdd(row, b1, du);
            duv = hn::MulAdd(slope, b1, duv);
            duu = hn::MulAdd(row, hn::Set(d, u.second[i][lane]), duu);
        }
        hn::Store(value, d, jet.value.data() + c);
        hn::Store(du, d, jet.du.data() + c);
        hn::Store(dv, d, jet.dv.data() + c);
        hn::Store(duu, d, jet.duu.data() + c);
        hn::Store(duv, d, jet.duv.data() + c);
        hn::Store(dvv, d, jet.dvv.data() + c);
    }
    return jet;
}

/// Jet of a patch at one place. Requires degrees of at least 1.
HomogeneousJet evaluate(const BezierPatchView& patch, const Vec2& uv) {
    const BasisJet<One> u(static_cast<std::size_t>(patch.degree_u), hn::Set(One(), uv.x));
    const BasisJet<One> v(static_cast<std::size_t>(patch.degree_v), hn::Set(One(), uv.y));
    return jet_at(patch, u, v, 0);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
