#pragma once

#include "keiko/base/units.h"
#include "keiko/scene/criteria_preset.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace keiko {

/// Mismatch of two signed curvatures k1, k2 in 1/mm, as a share of 1. The curvatures to which the
/// change is compared count as at least 1 / `flat_radius` (mm): flatter ones are practically flat.
/// This follows flat_curvature_radius_tolerance of g2_discontinuity_between_adjacent_faces in ISO
/// 10303-59. The mismatch is continuous in both curvatures.
inline double curvature_mismatch(CurvatureFormula formula, double k1, double k2,
                                 double flat_radius) {
    const double change = std::abs(k1 - k2), flat = 1 / flat_radius;
    // |R1 - R2| / (R1 + R2) = |k1 - k2| / (|k1| + |k2|) for curvatures of one sign.
    const double base = formula == CurvatureFormula::alias
                            ? std::max(std::abs(k1) + std::abs(k2), 2 * flat)
                            : std::max({std::abs(k1), std::abs(k2), flat});
    return base > 0 ? change / base : 0;
}

/// How far the mismatch of two curvatures may be off where their difference is, by `change` 1/mm.
inline double curvature_mismatch_error(CurvatureFormula formula, double k1, double k2,
                                       double flat_radius, double change) {
    if (!(change > 0)) return 0;
    const double flat = (formula == CurvatureFormula::alias ? 2 : 1) / flat_radius;
    const double base = formula == CurvatureFormula::alias ? std::abs(k1) + std::abs(k2)
                                                           : std::max(std::abs(k1), std::abs(k2));
    const double mismatch = curvature_mismatch(formula, k1, k2, flat_radius);
    return (1 + mismatch) * change / std::max({base - change, flat, 1e-300});
}

/// "alias", "catia"
constexpr std::string_view name_of(CurvatureFormula formula) {
    return formula == CurvatureFormula::alias ? "alias" : "catia";
}

/// The formula as printed beside its value.
constexpr std::string_view formula_text(CurvatureFormula formula) {
    return formula == CurvatureFormula::alias ? "|R1-R2|/(R1+R2)" : "|C1-C2|/max(|C1|,|C2|)";
}

/// G3 as an angle, in degrees: between the tangents of the plots of the radius of curvature over
/// arc length on the two sides of a seam, tan = R' = -k' / k^2. It does not change with the size
/// of the part. `k` in 1/mm, `slope` = k' in 1/mm2. CATIA, which states G3 in degrees, does not
/// print its formula; this is Keiko's reading.
inline double slope_angle(double k1, double slope1, double k2, double slope2) {
    const double first = std::atan2(slope1, k1 * k1), second = std::atan2(slope2, k2 * k2);
    return radians_to_degrees(std::abs(first - second));
}

/// Degrees by which slope_angle may be off where the curvatures are, together, by `k` 1/mm and
/// their slopes by `slope` 1/mm2.
inline double slope_angle_error(double k1, double k2, double k, double slope) {
    if (!(k > 0) && !(slope > 0)) return 0;
    const double least = std::max(std::min(std::abs(k1), std::abs(k2)) - k, 0.0);
    if (!(least > 0)) return 180;
    return std::min(180.0, radians_to_degrees(k / least + slope / (least * least)));
}

} // namespace keiko
