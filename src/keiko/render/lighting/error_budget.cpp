#include "keiko/render/lighting/error_budget.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

double ratio(double wrong, double allowed) {
    if (wrong == 0) return 0;
    const double ratio = wrong / allowed;
    return ratio >= 0 ? ratio : std::numeric_limits<double>::infinity();
}

} // namespace

ErrorBudget::ErrorBudget(const Integrator& integrator, const ShadingPoint& point, const Rgb& seen,
                         const DirectLight& total, double error)
    : weight_(point.weight),
      sent_(integrator.luminance(point, {Rgb(1), {}, 0})),
      luminance_(error * max_channel(seen + weight_ * integrator.luminance(point, total))),
      incident_(error * total.incident) {}

double ErrorBudget::used_by(const DirectLight& wrong) const {
    const Rgb off = weight_ * (sent_ * wrong.illuminance + wrong.lobes);
    const double most = std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
    if (std::isnan(off.r + off.g + off.b)) return std::numeric_limits<double>::infinity();
    return std::max(ratio(most, luminance_), ratio(std::abs(wrong.incident), incident_));
}

} // namespace keiko
