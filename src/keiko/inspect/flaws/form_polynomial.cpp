#include "keiko/inspect/flaws/form_polynomial.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Index of the first power of a total degree.
constexpr std::size_t first_of(std::size_t degree) {
    return degree * (degree + 1) / 2;
}

std::size_t degree_of(std::size_t term) {
    std::size_t degree = 0;
    while (powers_to(degree) <= term) ++degree;
    return degree;
}

/// Index of the product of two terms among the powers: its exponent of y is the sum of theirs.
std::size_t product_of(std::size_t i, std::size_t j, FormDomain domain) {
    if (domain == FormDomain::line) return i + j;
    const std::size_t a = degree_of(i), b = degree_of(j);
    return first_of(a + b) + (i - first_of(a)) + (j - first_of(b));
}

} // namespace

FormPowers powers_at(double x, double y, FormDomain domain) {
    constexpr std::size_t degrees = 2 * form_degree + 1;
    std::array<double, degrees> px{1}, py{1};
    for (std::size_t k = 1; k < degrees; ++k) px[k] = px[k - 1] * x, py[k] = py[k - 1] * y;
    FormPowers powers{};
    if (domain == FormDomain::line) {
        std::copy(px.begin(), px.end(), powers.begin());
        return powers;
    }
    std::size_t index = 0;
    for (std::size_t degree = 0; degree < degrees; ++degree)
        for (std::size_t k = 0; k <= degree; ++k) powers[index++] = px[degree - k] * py[k];
    return powers;
}

bool PolynomialFit::decompose() {
    constexpr double singular = 1e-12;
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double entry = sums_[product_of(i, j, domain_)];
            double rest = entry;
            for (std::size_t k = 0; k < j; ++k) rest -= matrix_[i][k] * matrix_[j][k];
            if (i == j && !(rest > singular * entry)) return false;
            matrix_[i][j] = i == j ? std::sqrt(rest) : rest / matrix_[j][j];
        }
    return true;
}

FormTerms PolynomialFit::solved(FormTerms t) const {
    for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t k = 0; k < i; ++k) t[i] -= matrix_[i][k] * t[k];
        t[i] /= matrix_[i][i];
    }
    for (std::size_t i = count_; i-- > 0;) {
        for (std::size_t k = i + 1; k < count_; ++k) t[i] -= matrix_[k][i] * t[k];
        t[i] /= matrix_[i][i];
    }
    std::fill(t.begin() + static_cast<std::ptrdiff_t>(count_), t.end(), 0.0);
    return t;
}

} // namespace keiko
