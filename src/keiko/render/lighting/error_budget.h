#pragma once

#include "keiko/render/shading/integrator.h"

namespace keiko {

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
