#include "keiko/patch/bernstein.h"

#include <algorithm>
#include <cassert>

namespace keiko {
namespace {

/// Row of degree n holding a (k-1)-th derivative of degree n - 1: d/dt B_i^n = n (B_{i-1} - B_i).
void differentiate(BernsteinRow& row, int n) {
    const auto at = [&](int i) -> double& { return row[static_cast<std::size_t>(i)]; };
    at(n) = n * at(n - 1);
    for (int i = n - 1; i > 0; --i) at(i) = n * (at(i - 1) - at(i));
    at(0) *= -n;
}

} // namespace

std::array<BernsteinRow, 4> bernstein_derivatives(int degree, double t, int order) {
    assert(degree >= 0 && degree <= max_degree && order >= 0 && order <= 3);
    std::array<BernsteinRow, 4> rows{};
    BernsteinRow row{};
    row[0] = 1;
    for (int n = 0; n <= degree; ++n) {
        if (n > 0) raise_degree(row, static_cast<std::size_t>(n), t);
        const int k = degree - n;
        if (k > order) continue;
        BernsteinRow derived = row;
        for (int m = n + 1; m <= degree; ++m) differentiate(derived, m);
        rows[static_cast<std::size_t>(k)] = derived;
    }
    return rows;
}

} // namespace keiko
