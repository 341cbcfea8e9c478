#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

/// Integral of (al cos eta + nz sin eta) cos eta over the elevations [low, high] as far as it is
/// positive (docs/theory/luminance.md#a-tube).
inline double arc_integral(double al, double nz, double low, double high) {
    const double zenith = std::atan2(nz, al);
    low = std::max(low, zenith - std::numbers::pi / 2);
    high = std::min(high, zenith + std::numbers::pi / 2);
    if (!(low < high)) return 0;
    const double span = high - low, sum = high + low;
    return (al * (span + std::cos(sum) * std::sin(span)) + nz * std::sin(sum) * std::sin(span)) / 2;
}

} // namespace keiko
