#pragma once

#include "keiko/render/shading/integrator.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace keiko {

/// Numbers of lights, rising.
using Lights = std::vector<std::size_t>;

bool holds(const Lights& lights, std::size_t light);
Lights without(const Lights& lights, const Lights& taken);

Lights united(const Lights& a, const Lights& b);
Lights common(const Lights& a, const Lights& b);

/// How far a light may be off, as a share of the error that is allowed.
struct LightError {
    std::size_t light;
    double error = 0;

    void add(double other) { error = std::max(error, other); }
};

/// Errors of lights, 0 for each of them yet.
std::vector<LightError> errors_in(const Lights& lights);
/// Lights with an error of no more than `most`.
Lights within(const std::vector<LightError>& errors, double most);
/// The lights in which there is least doubt, as long as all together are within what is `left` of
/// the error, which they lessen.
Lights least_erroneous(std::vector<LightError> errors, double& left);

/// How far the light at a place of a picture may be off.
class ErrorBudget {
public:
    /// By `error` of what the eye sees there, which is `seen` besides the light `total`; of that
    /// light's illuminance as well.
    ErrorBudget(const Integrator& integrator, const ShadingPoint& point, const Rgb& seen,
                const DirectLight& total, double error);

    /// The share of it that light uses up that is wrong by so much: infinite where nothing is
    /// allowed, or what is wrong is no number.
    double used_by(const DirectLight& wrong) const;

private:
    Rgb weight_; ///< of what the place sends to the eye, in the picture
    Rgb sent_;   ///< cd/m2 a lx on the base
    double luminance_, incident_;
};

} // namespace keiko
