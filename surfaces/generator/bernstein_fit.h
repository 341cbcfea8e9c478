#pragma once

#include <vector>

namespace keiko::fixtures {

/// The parameters in [0, 1] at which `bernstein_fit` wants its samples: Chebyshev-Lobatto points,
/// ends included, for which interpolation converges as fast as the curve is smooth.
std::vector<double> fit_parameters(int degree);

/// Bernstein coefficients of the polynomial through `samples` at `fit_parameters`. The first and
/// last coefficients are the first and last samples exactly.
std::vector<double> bernstein_fit(const std::vector<double>& samples);

} // namespace keiko::fixtures
