#pragma once

#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"

#include <array>
#include <functional>

namespace keiko {

/// Integral of a kernel over all directions of light above the horizon: the share of even light,
/// 0 to 1, that the surface sends to the eye, which sees it under `cosine` above 0. To about
/// `allowed`.
Rgb directional_albedo(const Gloss& gloss, double cosine, double allowed = 1e-5);
Rgb directional_albedo(const Flakes& flakes, double cosine, double allowed = 1e-5);

/// Directional albedos kept by the cosine, and their mean over the hemisphere.
class AlbedoTable {
public:
    explicit AlbedoTable(const std::function<Rgb(double cosine)>& albedo);

    /// Linear in between; to about 1e-3.
    Rgb operator()(double cosine) const;
    /// Twice the integral of the table times the cosine over the cosines from 0 to 1.
    const Rgb& mean() const { return mean_; }

private:
    static constexpr std::size_t steps = 64;
    std::array<Rgb, steps + 1> values_; ///< at equal steps of the square root of the cosine
    Rgb mean_;
};

} // namespace keiko
