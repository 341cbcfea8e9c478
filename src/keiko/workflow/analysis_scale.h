#pragma once

#include "keiko/workflow/film_sight.h"

#include <vector>

namespace keiko {

/// Percent of a body's picture that colours span by default.
constexpr double usual_percentile = 98;

/// The finite values of pixels that show the body.
std::vector<double> body_values(const FilmSight& sight, const PixelValues& values);

/// The least of the finite values that `percent` of them, 0 to 100, do not exceed; 0 without any.
double quantile(std::vector<double> values, double percent);
/// quantile() of absolute values.
double quantile_of_sizes(std::vector<double> values, double percent);

} // namespace keiko
