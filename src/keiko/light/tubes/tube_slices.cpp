#include "keiko/light/tubes/tube_slices.h"

#include "keiko/math/quadrature.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

std::vector<AcrossNode> made(int nodes) {
    std::vector<AcrossNode> rule;
    double sum = 0;
    for (const QuadratureNode& node : gauss_legendre(nodes)) {
        rule.push_back({node.x, node.weight, std::sqrt(1 - node.x * node.x)});
        sum += rule.back().weight * rule.back().rim;
    }
    for (AcrossNode& node : rule) node.rim *= std::numbers::pi / 2 / sum;
    return rule;
}

/// Light that arrives at the surface, and the part of it that enters.
struct Entry {
    double given = 0, entered = 0;

    Entry& operator+=(const Entry& other) {
        given += other.given;
        entered += other.entered;
        return *this;
    }
    Entry operator+(const Entry& other) const { return Entry(*this) += other; }
    Entry operator-(const Entry& other) const { return *this + other * -1; }
    Entry operator*(double weight) const { return {given * weight, entered * weight}; }
    double share() const { return given > 0 ? entered / given : 0; }
};

double largest_part(const Entry& entry) {
    return std::max(std::abs(entry.given), std::abs(entry.entered));
}

/// A half-plane through the point, by the tangent of half the elevation, which needs no angles.
struct HalfPlane {
    double level = 0, along = 0; ///< N.w = level cos eta + along sin eta

    Entry entry(const ClearCoat& coat, double begin, double end, int nodes) const {
        Entry sum;
        for (const QuadratureNode& node : gauss_legendre(nodes)) {
            const double t = (begin + end) / 2 + (end - begin) / 2 * node.x, q = 1 / (1 + t * t);
            const double elevation_cosine = (1 - t * t) * q;
            const double cosine = std::max(0.0, level * elevation_cosine + along * 2 * t * q);
            const double weight = node.weight * (end - begin) * elevation_cosine * q * cosine;
            sum += {weight, weight * coat.entering(cosine)};
        }
        return sum;
    }
};

HalfPlane half_plane(const TubeView& view, double psi) {
    return {view.n_lamp * std::cos(psi) + view.n_sideways * std::sin(psi), view.n_along};
}

/// Number of nodes along a lamp whose ends appear under cosines from `lowest` up: to 1e-3 each, for
/// indices up to 1.8. Fresnel's share is steep at grazing incidence.
int nodes_along(double span, double lowest) {
    if (span < 0.7 * lowest) return 2;
    if (span * span < lowest) return 3;
    if (span * span < 9 * lowest) return 4;
    return span * span < 18 * lowest ? 5 : 6;
}

/// Entering light of a lamp well above the horizon, by 1 or 2 half-planes, which have the same
/// elevations.
Entry in_few(const ClearCoat& coat, const TubeSlices& slices, int half_planes) {
    const TubeView& view = slices.view();
    const AcrossNode& node = width_quadrature(half_planes).back();
    const double psi = slices.half_angle() * node.x;
    const auto [begin, end] = slices.ends(psi, node.rim * view.radius);
    const auto cosine_at = [&](double x) {
        return (view.n_lamp * view.distance + view.n_along * x) /
               std::sqrt(x * x + view.distance * view.distance);
    };
    const VisiblePart& part = slices.part();
    const int nodes =
        nodes_along(end - begin, std::min(cosine_at(part.begin), cosine_at(part.end)));
    Entry sum = half_plane(view, psi).entry(coat, begin, end, nodes);
    if (half_planes > 1) sum += half_plane(view, -psi).entry(coat, begin, end, nodes);
    return sum;
}

Entry of_slice(const ClearCoat& coat, const TubeSlices& slices, double psi, double rim, int nodes) {
    const auto [begin, end] = slices.lit_ends(psi, rim);
    return begin < end ? half_plane(slices.view(), psi).entry(coat, begin, end, nodes) : Entry();
}

Entry in_four(const ClearCoat& coat, const TubeSlices& slices) {
    const TubeView& view = slices.view();
    Entry sum;
    for (const AcrossNode& node : width_quadrature(4))
        sum += of_slice(coat, slices, slices.half_angle() * node.x, node.rim * view.radius, 6) *
               node.weight;
    return sum;
}

/// Entering light by the angle that makes the outline smooth, as in cylinder_solid_angle(), halved
/// as needed where the horizon cuts the lamp.
Entry adaptively(const ClearCoat& coat, const TubeSlices& slices, double refinement, int nodes) {
    const double quarter = std::numbers::pi / 2, limit = std::sin(slices.half_angle());
    Breakpoints outline(-quarter, quarter);
    outline.cut_at(0);
    const auto slice = [&](double t) {
        const double sine = limit * std::sin(t), rim = slices.view().radius * std::cos(t);
        return of_slice(coat, slices, std::asin(sine), rim, nodes) *
               (std::cos(t) / std::sqrt((1 - sine) * (1 + sine)));
    };
    return integrate_paired(slice, outline, refinement, 12);
}

} // namespace

std::span<const AcrossNode> width_quadrature(int nodes) {
    static const std::array<std::vector<AcrossNode>, 3> rules{made(1), made(2), made(4)};
    assert(nodes == 1 || nodes == 2 || nodes == 4);
    return rules[nodes == 4 ? 2 : static_cast<std::size_t>(nodes - 1)];
}

double entering_share(const ClearCoat& coat, const TubeSlices& slices, TubeModel model) {
    if (model == TubeModel::automatic || model == TubeModel::cylinder)
        return adaptively(coat, slices, 1e-8, 24).share();
    // The error of one half-plane is of order dip^2, that of two dip^4, and that of the rims' mean
    // (d/D)^2: a test holds them to 2.3e-3.
    const double dip = slices.dip(), ratio = slices.view().ratio();
    if (slices.whole() && dip < 0.07 && ratio < 0.1) return in_few(coat, slices, 1).share();
    if (slices.whole() && dip < 0.4 && ratio < 0.15) return in_few(coat, slices, 2).share();
    if (!std::isfinite(dip)) return adaptively(coat, slices, 2e-2, 6).share();
    return in_four(coat, slices).share();
}

} // namespace keiko
