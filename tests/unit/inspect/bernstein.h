#pragma once

#include <array>
#include <cstddef>

namespace keiko::test {

/// Bernstein coefficients over [begin, begin + extent] of a polynomial by its coefficients.
template <std::size_t n>
std::array<double, n> bernstein(std::array<double, n> by_power, double begin, double extent) {
    for (std::size_t k = 0; k + 1 < n; ++k) // the polynomial about `begin`
        for (std::size_t i = n - 1; i-- > k;) by_power[i] += begin * by_power[i + 1];
    double scale = 1;
    for (double& a : by_power) a *= scale, scale *= extent;
    std::array<double, n> coefficients{};
    for (std::size_t j = 0; j < n; ++j) {
        double share = 1; // C(j, i) / C(n - 1, i)
        for (std::size_t i = 0; i <= j; ++i) {
            coefficients[j] += share * by_power[i];
            share *= double(j - i) / double(n - 1 - i);
        }
    }
    return coefficients;
}

} // namespace keiko::test
