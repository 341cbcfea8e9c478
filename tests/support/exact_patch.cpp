#include "tests/support/exact_patch.h"

#include <algorithm>
#include <array>

namespace keiko::test {
namespace {

using Row = std::array<Long, max_degree + 1>;

/// Bernstein polynomials of a degree and their derivatives.
struct Basis {
    Row value, slope;
};

Basis basis(int degree, Long t) {
    Basis b;
    b.value.fill(0);
    b.slope.fill(0);
    b.value[0] = 1;
    const auto n = static_cast<std::size_t>(degree);
    for (std::size_t k = 1; k <= n; ++k) {
        if (k == n)
            for (std::size_t i = 0; i <= n; ++i)
                b.slope[i] = static_cast<Long>(degree) *
                             ((i > 0 ? b.value[i - 1] : 0) - (i < n ? b.value[i] : 0));
        for (std::size_t i = k + 1; i-- > 0;)
            b.value[i] = b.value[i] * (1 - t) + (i > 0 ? b.value[i - 1] * t : 0);
    }
    return b;
}

} // namespace

ExactPatch::ExactPatch(const BezierPatchView& patch, const Affine& to_world)
    : degree_u_(patch.degree_u), degree_v_(patch.degree_v) {
    const auto row = [&](unsigned k) { return lengthened(to_world.rows[k]); };
    std::vector<LongVec3> places;
    for (const Vec4& p : patch.points) {
        const LongVec3 own = LongVec3(p.x, p.y, p.z) / static_cast<Long>(p.w);
        places.push_back(LongVec3(row(0).dot(own), row(1).dot(own), row(2).dot(own)) +
                         lengthened(to_world.translation));
        bounds_.extend(shortened(places.back()));
    }
    center_ = lengthened(bounds_.center());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Long w = patch.points[i].w;
        points_.push_back({(places[i] - center_) * w, w});
        radius_ = std::max(radius_, (places[i] - center_).length());
    }
    const Long steps = static_cast<Long>(2 * (degree_u_ + degree_v_) + 16);
    rounding_ = long_epsilon * (steps * radius_ + 8 * lengthened(bounds_.center()).length());
}

ExactPatch::Point ExactPatch::at(Long u, Long v) const {
    const Basis in_u = basis(degree_u_, u), in_v = basis(degree_v_, v);
    Weighted s{LongVec3(0), 0}, su = s, sv = s;
    const auto add = [](Weighted& sum, const Weighted& term, Long factor) {
        sum.p += term.p * factor;
        sum.w += term.w * factor;
    };
    const Weighted* point = points_.data();
    for (std::size_t i = 0; i <= static_cast<std::size_t>(degree_u_); ++i) {
        Weighted row{LongVec3(0), 0}, slope = row;
        for (std::size_t j = 0; j <= static_cast<std::size_t>(degree_v_); ++j, ++point) {
            add(row, *point, in_v.value[j]);
            add(slope, *point, in_v.slope[j]);
        }
        add(s, row, in_u.value[i]);
        add(su, row, in_u.slope[i]);
        add(sv, slope, in_u.value[i]);
    }
    const LongVec3 local = s.p / s.w;
    return {center_ + local, (su.p - local * su.w) / s.w, (sv.p - local * sv.w) / s.w};
}

} // namespace keiko::test
