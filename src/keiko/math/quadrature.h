#pragma once

#include "keiko/math/rgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace keiko {

/// One node of a rule on [-1, 1].
struct QuadratureNode {
    double x = 0;      ///< place, -1 to 1
    double weight = 0; ///< above 0; those of a rule sum to 2
};

/// Gauss-Legendre nodes on [-1, 1], computed once per order and kept; exact for polynomials of
/// degree 2 `order` - 1. Requires 1 <= order <= 64.
std::span<const QuadratureNode> gauss_legendre(int order);

/// Integral of f over [a, b] by one Gauss-Legendre panel.
template <class F>
auto integrate(const F& f, double a, double b, int order) {
    const double half = (b - a) / 2, middle = (a + b) / 2;
    const std::span<const QuadratureNode> nodes = gauss_legendre(order);
    const auto share = [&](const QuadratureNode& node) {
        return f(middle + half * node.x) * (node.weight * half);
    };
    auto sum = share(nodes.front());
    for (const QuadratureNode& node : nodes.subspan(1)) sum += share(node);
    return sum;
}

/// Size of a number: its absolute value.
inline double largest_part(double value) {
    return std::abs(value);
}
/// Size of a colour: the largest absolute value of its three parts.
inline double largest_part(const Rgb& value) {
    return std::max({std::abs(value.r), std::abs(value.g), std::abs(value.b)});
}

/// Integral of f over [a, b] by Gauss panels of 8 and 16 nodes, halved until these agree within
/// `allowed` or `depth` times.
template <class F>
auto integrate_adaptively(const F& f, double a, double b, double allowed, int depth = 12) {
    const auto coarse = integrate(f, a, b, 8), fine = integrate(f, a, b, 16);
    if (depth == 0 || !(largest_part(fine - coarse) > allowed)) return fine;
    const double middle = (a + b) / 2;
    return integrate_adaptively(f, a, middle, allowed / 2, depth - 1) +
           integrate_adaptively(f, middle, b, allowed / 2, depth - 1);
}

/// A range in the pieces between some places.
class Breakpoints {
public:
    static constexpr std::size_t most_pieces = 9; ///< that a range may be cut into

    /// Range without cuts; requires begin <= end.
    Breakpoints(double begin, double end) : places_{begin, end} {}

    /// Places outside of the range do not count. Throws std::length_error for more than
    /// `most_pieces`.
    void cut_at(double x) {
        if (!(x > places_[0] && x < places_[last_])) return;
        if (last_ + 1 == places_.size()) throw std::length_error("a range of too many pieces");
        std::size_t at = ++last_;
        for (; places_[at - 1] > x; --at) places_[at] = places_[at - 1];
        places_[at] = x;
    }
    /// Begin, cuts and end, rising.
    std::span<const double> places() const { return std::span(places_).first(last_ + 1); }

private:
    std::array<double, most_pieces + 1> places_{};
    std::size_t last_ = 1;
};

/// Sum of `f(a, b)` over the pieces from begin to end.
template <class F>
auto sum_over_pieces(const Breakpoints& range, const F& f) {
    const std::span<const double> places = range.places();
    auto sum = f(places[0], places[1]);
    for (std::size_t i = 1; i + 1 < places.size(); ++i) sum += f(places[i], places[i + 1]);
    return sum;
}

/// One integral by two rules.
template <class T>
struct GaussKronrodSum {
    T fine;   ///< by Kronrod's rule
    T coarse; ///< by Gauss's rule

    /// Difference of both, by its largest part.
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
