#pragma once

#include "keiko/math/adaptive_quadrature.h"
#include "keiko/math/breakpoints.h"

#include <array>

namespace keiko {

/// One integral by two rules.
template <class T>
struct GaussKronrodSum {
    T fine, coarse;

    double apart() const { return largest_part(fine - coarse); }
};

/// Integral of f over [a, b] by Gauss's rule of 4 nodes and by Kronrod's of 9 [Kronrod1965], which
/// has these among its own: exact for polynomials of degrees 7 and 13.
template <class F>
auto paired_panel(const F& f, double a, double b) {
    struct Node {
        double x, fine, coarse; // weights
    };
    static constexpr double in_the_middle = 0.34644298189013636168;
    static constexpr std::array<Node, 4> beside{{
        {0.33998104358485626480, 0.32694918960145162956, 0.65214515486254614263},
        {0.64028621749630998240, 0.26679834045228444803, 0},
        {0.86113631159405257522, 0.17005360533572272680, 0.34785484513745385737},
        {0.97656025073757311153, 0.06297737366547301477, 0},
    }};
    const double half = (b - a) / 2, middle = (a + b) / 2;
    auto fine = f(middle) * in_the_middle;
    auto coarse = fine * 0;
    for (const Node& node : beside) {
        const auto both = f(middle - half * node.x) + f(middle + half * node.x);
        fine += both * node.fine;
        coarse += both * node.coarse;
    }
    return GaussKronrodSum<decltype(fine)>{fine * half, coarse * half};
}

/// The finer of both, halved until they agree within `allowed` or `depth` times.
template <class F, class T>
T refined(const F& f, const GaussKronrodSum<T>& sum, double a, double b, double allowed,
          int depth) {
    if (depth == 0 || !(sum.apart() > allowed)) return sum.fine;
    const double middle = (a + b) / 2;
    const auto below = paired_panel(f, a, middle), above = paired_panel(f, middle, b);
    return refined(f, below, a, middle, allowed / 2, depth - 1) +
           refined(f, above, middle, b, allowed / 2, depth - 1);
}

/// Integral of f over a range in pieces, each halved until both rules agree within its share of
/// `relative` times the whole. The finer rule's error is smaller by far: it goes about with the
/// power 7/4 of what they differ by.
template <class F>
auto integrate_paired(const F& f, const Breakpoints& range, double relative, int depth = 6) {
    const std::span<const double> places = range.places();
    const std::size_t pieces = places.size() - 1;
    std::array<decltype(paired_panel(f, 0, 0)), Breakpoints::most_pieces> sums{};
    auto whole = (sums[0] = paired_panel(f, places[0], places[1])).fine;
    for (std::size_t i = 1; i < pieces; ++i)
        whole += (sums[i] = paired_panel(f, places[i], places[i + 1])).fine;
    const double allowed = relative * largest_part(whole) / static_cast<double>(pieces);
    auto sum = refined(f, sums[0], places[0], places[1], allowed, depth);
    for (std::size_t i = 1; i < pieces; ++i)
        sum += refined(f, sums[i], places[i], places[i + 1], allowed, depth);
    return sum;
}

} // namespace keiko
