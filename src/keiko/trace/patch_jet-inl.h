// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_PATCH_JET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_PATCH_JET_INL_H
#undef KEIKO_TRACE_PATCH_JET_INL_H
#else
#define KEIKO_TRACE_PATCH_JET_INL_H
#endif

#include "keiko/trace/lanes-inl.h"
#include "keiko/trace/leaf_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Bernstein polynomials of one degree and their first two derivatives.
class BasisJet {
public:
    BernsteinRow value, first, second;

    BasisJet(std::size_t degree, double t) {
        value[0] = 1;
        std::size_t n = 0;
        while (n + 2 < degree) raise_degree(value, ++n, t);
        // The row of degree n becomes the second derivative, the next one the first.
        if (n + 2 == degree) {
            difference_twice(n, static_cast<double>(degree * (degree - 1)));
            raise_degree(value, ++n, t);
        } else {
            second[0] = second[1] = 0;
        }
        const double factor = static_cast<double>(degree);
        first[0] = -factor * value[0];
        for (std::size_t i = 1; i < degree; ++i) first[i] = factor * (value[i - 1] - value[i]);
        first[degree] = factor * value[degree - 1];
        raise_degree(value, degree, t);
    }

private:
    void difference_twice(std::size_t n, double factor) {
        for (std::size_t i = 0; i <= n + 2; ++i) {
            const double here = i <= n ? value[i] : 0,
                         before = i > 0 && i <= n + 1 ? value[i - 1] : 0;
            const double first_of_two = i > 1 ? value[i - 2] : 0;
            second[i] = factor * (here - 2 * before + first_of_two);
        }
    }
};

HomogeneousJet evaluate(const BezierPatchView& patch, const Vec2& uv) {
    const hn::CappedTag<double, 4> d;
    const auto rows = static_cast<std::size_t>(patch.degree_u);
    const auto columns = static_cast<std::size_t>(patch.degree_v);
    const BasisJet u(rows, uv.x), v(columns, uv.y);
    HomogeneousJet jet;
    for (std::size_t c = 0; c < 4; c += hn::Lanes(d)) {
        auto value = hn::Zero(d), du = value, dv = value, duu = value, duv = value, dvv = value;
        const Vec4* point = patch.points.data();
        for (std::size_t i = 0; i <= rows; ++i) {
            auto row = hn::Zero(d), slope = row, bend = row;
            for (std::size_t j = 0; j <= columns; ++j, ++point) {
                const auto p = hn::LoadU(d, &point->x + c);
                row = hn::MulAdd(p, hn::Set(d, v.value[j]), row);
                slope = hn::MulAdd(p, hn::Set(d, v.first[j]), slope);
                bend = hn::MulAdd(p, hn::Set(d, v.second[j]), bend);
            }
            const auto b = hn::Set(d, u.value[i]), b1 = hn::Set(d, u.first[i]);
            value = hn::MulAdd(row, b, value);
            dv = hn::MulAdd(slope, b, dv);
            dvv = hn::MulAdd(bend, b, dvv);
            du = hn::MulAdd(row, b1, du);
            duv = hn::MulAdd(slope, b1, duv);
            duu = hn::MulAdd(row, hn::Set(d, u.second[i]), duu);
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

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
