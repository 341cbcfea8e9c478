#pragma once

#include "keiko/math/function_place.h"

#include <algorithm>
#include <cmath>

namespace keiko {

/// A root of `f` between two places where its signs differ, to `enough` > 0 of its argument
/// [Chandrupatla1997]: inverse quadratic interpolation through the last three places where these
/// permit it, else halving. The root never leaves its bracket. A value of 0 counts as positive.
/// Smooth functions take some six evaluations.
template <class F>
double bracketed_root(const F& f, FunctionPlace a, FunctionPlace b, double enough) {
    const auto is_negative = [](const FunctionPlace& place) { return place.value < 0; };
    constexpr int most = 100; // NaN satisfies nothing
    double share = a.value / (a.value - b.value);
    for (int i = 0; i < most; ++i) {
        const double at = a.at + share * (b.at - a.at);
        const FunctionPlace next{at, f(at)};
        const bool same_side = is_negative(next) == is_negative(a);
        const FunctionPlace c = same_side ? a : b; // where the third value is
        if (!same_side) b = a;
        a = next;
        const FunctionPlace& best = std::abs(a.value) < std::abs(b.value) ? a : b;
        const double least = enough / std::abs(b.at - a.at);
        if (best.value == 0 || !(least < 0.5)) return best.at;
        const double xi = (a.at - b.at) / (c.at - b.at);
        const double phi = (a.value - b.value) / (c.value - b.value);
        const bool curved_little = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
        share = 0.5;
        if (curved_little)
            share = a.value / (b.value - a.value) * c.value / (b.value - c.value) +
                    (c.at - a.at) / (b.at - a.at) * a.value / (c.value - a.value) * b.value /
                        (c.value - b.value);
        share = std::clamp(share, least, 1 - least);
    }
    return a.at;
}

} // namespace keiko
