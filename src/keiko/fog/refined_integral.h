#pragma once

#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace keiko {

/// Integral of a colour over pieces of a line, each smooth inside, by Gauss quadrature: pieces are
/// halved where rules of `order` and twice that many nodes differ.
template <class F>
class RefinedIntegral {
public:
    RefinedIntegral(const F& f, double tolerance) : f_(f), tolerance_(tolerance) {}

    /// Over the pieces between neighbouring `ends`, which rise.
    Rgb operator()(std::span<const double> ends) const {
        const int order = order_of(ends.size() - 1);
        std::vector<Rgb> first;
        double scale = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            first.push_back(integrate(f_, ends[i], ends[i + 1], order));
            scale += max_channel(first.back());
        }
        const double allowed = tolerance_ * scale / (ends.back() - ends.front());
        Rgb sum;
        for (std::size_t i = 0; i < first.size(); ++i)
            sum += refined(ends[i], ends[i + 1], first[i], order, allowed, most_halvings);
        return sum;
    }

private:
    static constexpr int most_halvings = 12;

    /// Between the many kinks of a table there is little left to follow.
    int order_of(std::size_t pieces) const {
        constexpr std::size_t many = 6;
        return tolerance_ < 1e-6 ? 8 : pieces > many ? 2 : 4;
    }

    /// `allowed`: error per length.
    Rgb refined(double a, double b, const Rgb& coarse, int order, double allowed, int depth) const {
        const Rgb fine = integrate(f_, a, b, 2 * order), gap = fine - coarse;
        const double error = std::max({std::abs(gap.r), std::abs(gap.g), std::abs(gap.b)});
        if (depth == 0 || !(error > allowed * (b - a))) return fine;
        const double middle = (a + b) / 2;
        return refined(a, middle, integrate(f_, a, middle, order), order, allowed, depth - 1) +
               refined(middle, b, integrate(f_, middle, b, order), order, allowed, depth - 1);
    }

    const F& f_;
    double tolerance_;
};

} // namespace keiko
