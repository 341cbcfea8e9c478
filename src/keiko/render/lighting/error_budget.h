#pragma once

#include "keiko/render/shading/integrator.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace keiko {

/// Numbers of lights, rising.
using Lights = std::vector<std::size_t>;

/// True if a light is among `lights`.
bool holds(const Lights& lights, std::size_t light);
/// The lights that are not among `taken`.
Lights without(const Lights& lights, const Lights& taken);

/// Lights that are among either.
Lights united(const Lights& a, const Lights& b);
/// Lights that are among both.
Lights common(const Lights& a, const Lights& b);

/// Error of a light, as a share of the allowed error.
struct LightError {
    std::size_t light; ///< its number
    double error = 0;  ///< 0 or more; 1: all of what is allowed

    /// Makes the error the larger of itself and another; NaN does not count.
    void add(double other) { error = std::max(error, other); }
};

/// Errors of lights, all 0.
std::vector<LightError> errors_in(const Lights& lights);
/// Lights with an error of at most `most`.
Lights within(const std::vector<LightError>& errors, double most);
/// The lights with the smallest errors whose sum is within `left` of the error, which they reduce.
Lights least_erroneous(std::vector<LightError> errors, double& left);

/// Error allowed in the light at a place of a picture.
class ErrorBudget {
public:
    /// Budget of `error` of the visible luminance there, which is `seen` besides the light `total`,
    /// or of what PictureOptions::white makes of it; `error` itself applies to that light's
    /// illuminance. `besides`: what the light may be off in any case.
    ErrorBudget(const Integrator& integrator, const ShadingPoint& point, const Rgb& seen,
                const DirectLight& total, double error, const DirectLight& besides = {});

    /// Share of the budget that an error of the light uses up: infinite if nothing is allowed, or
    /// the error is NaN.
    double used_by(const DirectLight& wrong) const;
    /// Share of the visible luminance that is allowed, `error` or more.
    double share() const { return share_; }

private:
    Rgb weight_; ///< of the luminance from the place, in the picture
    Rgb sent_;   ///< cd/m2 a lx on the base
    double luminance_, incident_;
    double share_;
};

} // namespace keiko
