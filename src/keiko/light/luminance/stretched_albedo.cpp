#include "keiko/light/luminance/stretched_albedo.h"

#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Weight of a point in the barycentric formula of Chebyshev's points [Berrut2004], and of an end
/// in the trapezoidal rule: half.
double end_weight(std::size_t i, std::size_t count) {
    return i == 0 || i + 1 == count ? 0.5 : 1;
}

/// Chebyshev's points from 1 to -1.
double point_at(std::size_t i, std::size_t count) {
    return std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(count - 1));
}

/// Half vector at a share `t` of the facets by their slope, at an angle psi from the scratches in
/// slopes by the widths, in which the distribution is round.
Vec3 facet_at(const Distribution& facets, double t, double psi) {
    const double slope2 =
        facets.kind() == DistributionKind::beckmann ? -std::log1p(-t) : t / (1 - t);
    const double slope = std::sqrt(slope2);
    return Vec3(facets.width() * slope * std::cos(psi), facets.across() * slope * std::sin(psi), 1)
        .normalized();
}

/// Directional albedo as the mean over the facets: D cos(alpha) dw is dt dpsi / 2 pi.
Rgb albedo_by_facets(const Gloss& gloss, double cosine, double azimuth) {
    constexpr double least_cosine = 1e-3;
    constexpr int shares = 48, angles = 96;
    const double z = std::max(cosine, least_cosine), flat = std::sqrt(1 - std::min(1.0, z * z));
    const Vec3 eye(flat * std::cos(azimuth), flat * std::sin(azimuth), z);
    const GlossKernel kernel(gloss, Vec3(0, 0, 1), eye, Vec3(1, 0, 0));
    const auto ring = [&](double t) {
        Rgb sum;
        for (int i = 0; i < angles; ++i) {
            const Vec3 half = facet_at(gloss.distribution, t, 2 * std::numbers::pi * i / angles);
            const double vh = half.dot(eye), density = gloss.distribution.density(half) * half.z;
            if (vh > 0 && density > 0)
                sum += kernel(half * (2 * vh) - eye) * (4 * vh / (density * angles));
        }
        return sum;
    };
    return integrate(ring, 0, 1, shares);
}

} // namespace

StretchedAlbedo::StretchedAlbedo(const Gloss& gloss)
    : along2_(gloss.distribution.width() * gloss.distribution.width()),
      across2_(gloss.distribution.across() * gloss.distribution.across()) {
    const double first = width_at(1), last = width_at(-1);
    for (std::size_t i = 0; i < count; ++i) {
        const double width = (first + last) / 2 + (first - last) / 2 * point_at(i, count);
        const double sine2 = (width * width - along2_) / (across2_ - along2_);
        const double azimuth = std::asin(std::sqrt(std::clamp(sine2, 0.0, 1.0)));
        tables_[i] = std::make_shared<const AlbedoTable>(
            [&](double cosine) { return albedo_by_facets(gloss, cosine, azimuth); });
    }
    mean_ = std::make_shared<const AlbedoTable>([this](double cosine) {
        constexpr std::size_t azimuths = 33; // over a quarter of a turn
        Rgb sum;
        for (std::size_t i = 0; i < azimuths; ++i)
            sum += (*this)(cosine, point_at(i, azimuths)) * end_weight(i, azimuths);
        return sum / static_cast<double>(azimuths - 1);
    });
}

double StretchedAlbedo::width_at(double doubled) const {
    return std::sqrt((along2_ + across2_) / 2 + (along2_ - across2_) / 2 * doubled);
}

Rgb StretchedAlbedo::operator()(double cosine, double doubled) const {
    const double first = width_at(1), last = width_at(-1);
    const double place = (2 * width_at(doubled) - first - last) / (first - last);
    Rgb sum;
    double weights = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double off = place - point_at(i, count);
        const Rgb here = (*tables_[i])(cosine);
        if (std::abs(off) < 1e-12) return here;
        const double weight = end_weight(i, count) * (i % 2 == 0 ? 1 : -1) / off;
        sum += here * weight;
        weights += weight;
    }
    return sum / weights;
}

double doubled_azimuth_cosine(const Vec3& normal, const Vec3& eye, const Vec3& along) {
    const Vec3 seen = eye - normal * eye.dot(normal), flat = along - normal * along.dot(normal);
    const double lengths = seen.length2() * flat.length2(), product = seen.dot(flat);
    return lengths > 0 ? std::clamp(2 * product * product / lengths - 1, -1.0, 1.0) : 0;
}

} // namespace keiko
