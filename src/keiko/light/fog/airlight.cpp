#include "keiko/light/fog/airlight.h"

#include "keiko/math/quadrature.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace keiko {
namespace {

using Complex = std::complex<double>;

/// E1 by its power series, for |z| up to about 4.
Complex e1_series(const Complex& z) {
    Complex sum = 0, term = 1;
    for (int k = 1; k < 60; ++k) {
        term *= -z / static_cast<double>(k);
        sum -= term / static_cast<double>(k);
        if (std::abs(term) < 1e-18 * std::abs(sum)) break;
    }
    return -std::numbers::egamma - std::log(z) + sum;
}

/// exp(z) E1(z) by its continued fraction (Lentz), for larger z with a real part that is not
/// negative.
Complex scaled_e1_fraction(const Complex& z) {
    Complex b = z + 1.0, c = 1e300, d = 1.0 / b, h = d;
    for (int i = 1; i < 400; ++i) {
        const double a = -static_cast<double>(i) * i;
        b += 2.0;
        d = 1.0 / (a * d + b);
        c = b + a / c;
        const Complex step = c * d;
        h *= step;
        if (std::abs(step - 1.0) < 1e-16) break;
    }
    return h;
}

/// e^(-iu) E1(u (y - i)).
Complex turned_e1(double u, double y) {
    const Complex z(u * y, -u);
    if (std::abs(z) < 4) return std::polar(1.0, -u) * e1_series(z);
    // e^(-iu) e^(-z) = e^(-uy).
    return std::exp(-u * y) * scaled_e1_fraction(z);
}

} // namespace

double airlight(double u, double begin, double end) {
    const auto direct = [&](double xi) { return std::exp(-u * std::tan(xi)); };
    // Where nearly nothing is dimmed, or little is to be integrated, terms of the closed form
    // cancel, and the integrand is next to a polynomial.
    constexpr double quarter_turn = std::numbers::pi / 2, narrow = 0.05;
    const double width = end - begin;
    const bool smooth = quarter_turn - end > 3 * width && u * (std::tan(end) - std::tan(begin)) < 1;
    if (width < narrow && smooth) return integrate(direct, begin, end, 12);
    if (!(u > 0)) return width;
    const double last = end < quarter_turn ? std::tan(end) : HUGE_VAL;
    const Complex at_end = u * last < 700 ? turned_e1(u, last) : 0;
    return (turned_e1(u, std::tan(begin)) - at_end).imag();
}

} // namespace keiko
