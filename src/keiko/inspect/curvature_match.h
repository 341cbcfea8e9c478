#pragma once

#include "keiko/spec/criteria_preset.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace keiko {

/// Mismatch of two signed curvatures k1, k2 in 1/mm, as a share of 1; 0 where both vanish.
inline double curvature_mismatch(CurvatureFormula formula, double k1, double k2) {
    const double change = std::abs(k1 - k2);
    // |R1 - R2| / (R1 + R2) = |k1 - k2| / (|k1| + |k2|) for curvatures of one sign.
    const double base = formula == CurvatureFormula::alias ? std::abs(k1) + std::abs(k2)
                                                           : std::max(std::abs(k1), std::abs(k2));
    return base > 0 ? change / base : 0;
}

/// The formula as it is printed beside its value.
constexpr std::string_view formula_text(CurvatureFormula formula) {
    return formula == CurvatureFormula::alias ? "|R1-R2|/(R1+R2)" : "|C1-C2|/max(|C1|,|C2|)";
}

} // namespace keiko
