#include "keiko/visibility/nets/affine_bounds.h"

#include <algorithm>
#include <array>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of each component; in arrays, so that components run side by side.
struct Ranges {
    std::array<double, 4> low{infinity, infinity, infinity, infinity};
    std::array<double, 4> high{-infinity, -infinity, -infinity, -infinity};

    void add(const Vec4& p) {
        const std::array<double, 4> c{p.x, p.y, p.z, p.w};
        for (std::size_t k = 0; k < 4; ++k) {
            low[k] = c[k] < low[k] ? c[k] : low[k];
            high[k] = c[k] > high[k] ? c[k] : high[k];
        }
    }
    Vec4 middle() const { return (vec(low) + vec(high)) / 2; }
    Vec4 half() const { return (vec(high) - vec(low)) / 2; }
    /// Of the distances from a place.
    Vec4 farthest(const Vec4& from) const {
        const Vec4 below = from - vec(low), above = vec(high) - from;
        Vec4 most(0);
        for (unsigned k = 0; k < 4; ++k) most[k] = std::max(below[k], above[k]);
        return most;
    }

private:
    static Vec4 vec(const std::array<double, 4>& c) { return {c[0], c[1], c[2], c[3]}; }
};

/// In [-1, 1], of a row or column.
double place(int i, int degree) {
    return degree > 0 ? 2 * static_cast<double>(i) / degree - 1 : 0;
}

/// Of the derivative along an axis, from the steps between neighbours, without the affine part's.
Vec4 slope(const Ranges& steps, const Vec4& along, int degree) {
    if (degree == 0) return Vec4(0);
    const double half = static_cast<double>(degree) / 2;
    return steps.farthest(along / half) * half;
}

} // namespace

AffineBounds affine_bounds(const HomogeneousNet& net) {
    const int m = net.degree_u, n = net.degree_v;
    const BezierPatchView view = net.view();
    const Vec4 &a = view.point(0, 0), &b = view.point(m, 0), &c = view.point(0, n),
               &d = view.point(m, n);
    AffineBounds f;
    if (m > 0) f.along_x = (b + d - a - c) / 4;
    if (n > 0) f.along_y = (c + d - a - b) / 4;
    const auto columns = static_cast<std::size_t>(n) + 1;
    Ranges rest, by_u, by_v;
    for (int i = 0; i <= m; ++i) {
        const Vec4* const row = &net.points[static_cast<std::size_t>(i) * columns];
        const Vec4 of_row = f.along_x * place(i, m);
        for (std::size_t j = 0; j < columns; ++j) {
            rest.add(row[j] - of_row - f.along_y * place(static_cast<int>(j), n));
            if (i < m) by_u.add(row[j + columns] - row[j]);
            if (j + 1 < columns) by_v.add(row[j + 1] - row[j]);
        }
    }
    f.value = rest.middle();
    f.off = rest.half();
    constexpr double rounding = 1e-14;
    const Vec4 sizes = magnitudes(f.value) + magnitudes(f.along_x) + magnitudes(f.along_y) + f.off;
    const Vec4 room(rounding * sizes.length());
    f.off += room;
    f.slope = slope(by_u, f.along_x, m) + slope(by_v, f.along_y, n) + room;
    return f;
}

} // namespace keiko
