#pragma once

#include "keiko/math/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace keiko {

/// Corners of a triangle.
using TriangleCorners = std::array<Vec3, 3>;

/// Integral over a triangle by Radon's rule of seven points, exact for polynomials of degree 5
/// [Radon1948].
template <class F>
double integrate_over(const TriangleCorners& t, const F& f) {
    static const double root = std::sqrt(15.0);
    const auto orbit = [&](double inner) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += f(t[i] * (1 - 2 * inner) + (t[(i + 1) % 3] + t[(i + 2) % 3]) * inner);
        return sum;
    };
    const double area = (t[1] - t[0]).cross(t[2] - t[0]).length() / 2;
    return area * (f((t[0] + t[1] + t[2]) / 3) * (9.0 / 40) +
                   orbit((6 - root) / 21) * ((155 - root) / 1200) +
                   orbit((6 + root) / 21) * ((155 + root) / 1200));
}

/// Four triangles between the corners and the middles of the sides.
inline std::array<TriangleCorners, 4> quarters(const TriangleCorners& t) {
    const Vec3 a = (t[1] + t[2]) / 2, b = (t[2] + t[0]) / 2, c = (t[0] + t[1]) / 2;
    return {TriangleCorners{t[0], c, b}, TriangleCorners{c, t[1], a}, TriangleCorners{b, a, t[2]},
            TriangleCorners{a, b, c}};
}

/// An integral with an estimate of its error.
struct CubatureSum {
    double value = 0, error = 0; ///< in the unit of the integral
};

/// Integral over a convex polygon by triangles, quartered where the rule changes most by it, until
/// the sum of the changes is at most `allowed` or there are `most_parts`.
template <class F>
CubatureSum integrate_adaptively_over(std::span<const Vec3> corners, const F& f, double allowed,
                                      int most_parts) {
    struct Piece {
        TriangleCorners at;
        double value, change; // change: share of that of the triangle that it is a quarter of
    };
    std::vector<Piece> parts; // a heap
    CubatureSum sum;
    const auto less = [](const Piece& a, const Piece& b) { return a.change < b.change; };
    const auto add = [&](const Piece& part) {
        parts.push_back(part);
        std::push_heap(parts.begin(), parts.end(), less);
        sum.value += part.value, sum.error += part.change;
    };
    const auto quarter = [&](const TriangleCorners& whole, double value) {
        std::array<double, 4> values{};
        const auto triangles = quarters(whole);
        double fine = 0;
        for (std::size_t i = 0; i < 4; ++i) fine += values[i] = integrate_over(triangles[i], f);
        for (std::size_t i = 0; i < 4; ++i)
            add({triangles[i], values[i], std::abs(fine - value) / 4});
    };
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const TriangleCorners whole{corners[0], corners[i], corners[i + 1]};
        quarter(whole, integrate_over(whole, f));
    }
    while (sum.error > allowed && parts.size() + 3 <= static_cast<std::size_t>(most_parts)) {
        std::pop_heap(parts.begin(), parts.end(), less);
        const Piece worst = parts.back();
        parts.pop_back();
        sum.value -= worst.value, sum.error -= worst.change;
        quarter(worst.at, worst.value);
    }
    return sum;
}

} // namespace keiko
