#include "keiko/light/luminance/fresnel.h"

#include "keiko/math/quadrature.h"

#include <cmath>

namespace keiko {

namespace {

double square(double x) {
    return x * x;
}

/// Closed form of the mean [Walsh1926], n > 1 (docs/theory/luminance.md#fresnel-reflectance); its
/// relative error is about 1e-16 / (n - 1)^3.
double walsh_mean(double n) {
    const double n2 = n * n, n4 = n2 * n2;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * square(n + 1)) +
           n2 * square(n2 - 1) / (square(n2 + 1) * (n2 + 1)) * std::log((n - 1) / (n + 1)) -
           2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * square(n4 - 1)) * std::log(n);
}

/// Mean reflectance for 1 < n by quadrature in t with c = s sinh t, g = s cosh t, s^2 = n^2 - 1.
/// There (g - c) / (g + c) = exp(-2t), and the knee at grazing incidence is smooth.
double mean_by_quadrature(double n) {
    const double s = std::sqrt((n - 1) * (n + 1));
    const auto reflected = [s](double t) {
        const double c = s * std::sinh(t), growth = std::exp(t);
        const double ratio = (c * s * growth - 1) / (c * s / growth + 1);
        return 0.5 * std::exp(-4 * t) * (1 + ratio * ratio) * c * s * std::cosh(t);
    };
    return 2 * integrate(reflected, 0, std::asinh(1 / s), 64);
}

/// Index below which the closed form has lost more than 1e-12.
constexpr double closed_form_from = 1.2;

} // namespace

double fresnel_dielectric(double cosine, double n) {
    const double c = cosine, g2 = n * n + c * c - 1;
    if (!(g2 > 0)) return 1;
    const double g = std::sqrt(g2);
    const double amplitude = (g - c) / (g + c);
    const double ratio = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5 * amplitude * amplitude * (1 + ratio * ratio);
}

double fresnel_conductor(double cosine, double n, double k) {
    const double c = cosine, s2 = 1 - c * c, real = n * n - k * k - s2;
    const double q = std::hypot(real, 2 * n * k);
    const double a = std::sqrt((q + real) / 2);
    const double perpendicular = (q - 2 * a * c + c * c) / (q + 2 * a * c + c * c);
    const double parallel = perpendicular * (q * c * c - 2 * a * c * s2 + s2 * s2) /
                            (q * c * c + 2 * a * c * s2 + s2 * s2);
    return (perpendicular + parallel) / 2;
}

double fresnel_mean(double n) {
    if (n == 1) return 0;
    if (n < 1) return 1 - (1 - fresnel_mean(1 / n)) * n * n;
    return n < closed_form_from ? mean_by_quadrature(n) : walsh_mean(n);
}

} // namespace keiko
