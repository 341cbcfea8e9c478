#include "keiko/render/lighting/error_budget.h"

#include "keiko/film/tone_mapping.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace keiko {

bool holds(const Lights& lights, std::size_t light) {
    return std::binary_search(lights.begin(), lights.end(), light);
}

Lights without(const Lights& lights, const Lights& taken) {
    Lights rest;
    std::set_difference(lights.begin(), lights.end(), taken.begin(), taken.end(),
                        std::back_inserter(rest));
    return rest;
}

Lights united(const Lights& a, const Lights& b) {
    Lights both;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

Lights common(const Lights& a, const Lights& b) {
    Lights both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

Lights within(const std::vector<LightError>& errors, double most) {
    Lights lights;
    for (const LightError& doubt : errors)
        if (doubt.error <= most) lights.push_back(doubt.light);
    return lights;
}

std::vector<LightError> errors_in(const Lights& lights) {
    std::vector<LightError> errors;
    for (const std::size_t light : lights) errors.push_back({light});
    return errors;
}

Lights least_erroneous(std::vector<LightError> errors, double& left) {
    std::stable_sort(errors.begin(), errors.end(),
                     [](const LightError& a, const LightError& b) { return a.error < b.error; });
    Lights taken;
    for (const LightError& doubt : errors) {
        if (!(doubt.error <= left)) break;
        left -= doubt.error;
        taken.push_back(doubt.light);
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}

namespace {

double ratio(double wrong, double allowed) {
    if (wrong == 0) return 0;
    const double ratio = wrong / allowed;
    return ratio >= 0 ? ratio : std::numeric_limits<double>::infinity();
}

/// cd/m2 that a luminance may deviate by. `white`: as of PictureOptions.
double allowed_deviation(double luminance, double error, const std::optional<double>& white) {
    if (!white || !(luminance < *white)) return error * luminance;
    return error * *white * srgb_slope(1) / srgb_slope(luminance / *white);
}

} // namespace

ErrorBudget::ErrorBudget(const Integrator& integrator, const ShadingPoint& point, const Rgb& seen,
                         const DirectLight& total, double error, const DirectLight& besides)
    : weight_(point.weight),
      sent_(integrator.luminance(point, {Rgb(1), {}, 0})),
      incident_(error * (total + point.known).incident + besides.incident) {
    const auto shown_by = [&](const DirectLight& light) {
        return weight_ * integrator.luminance(point, light);
    };
    const double shown = max_channel(seen + shown_by(total + point.known));
    luminance_ =
        allowed_deviation(shown, error, integrator.white()) + max_channel(shown_by(besides));
    share_ = shown > 0 ? luminance_ / shown : error;
}

double ErrorBudget::used_by(const DirectLight& wrong) const {
    const Rgb off = weight_ * (sent_ * wrong.illuminance + wrong.lobes);
    const double most = std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
    if (std::isnan(off.r + off.g + off.b)) return std::numeric_limits<double>::infinity();
    return std::max(ratio(most, luminance_), ratio(std::abs(wrong.incident), incident_));
}

} // namespace keiko
