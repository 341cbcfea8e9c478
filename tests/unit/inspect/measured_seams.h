// Seams of sheets along the x axis, as they are measured.
#pragma once

#include "keiko/base/units.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keiko::test {

constexpr double join = 0.5; ///< mm

inline std::vector<MeasuredSeam> measured(const SurfaceModel& model,
                                          const CriteriaPreset& preset = {}) {
    return measure_seams(model, pair_seams(model, join), preset, join).seams;
}

inline MeasuredSeam only_seam(const ModelBuilder& builder, const CriteriaPreset& preset = {}) {
    const auto seams = measured(builder.build(), preset);
    EXPECT_EQ(seams.size(), 1u);
    return seams.at(0);
}

/// The direction outwards from the x axis, `degrees` below the plane's continuation into -y.
inline Vec3 down(double degrees, double length = 50) {
    const double angle = degrees_to_radians(degrees);
    return {0, -length * std::cos(angle), -length * std::sin(angle)};
}

/// c u^2 (1 - u) peaks at u = 2/3 with 4/27 c.
inline const std::vector<double> hump{0, 0, 1.0 / 3, 0};
constexpr double peak = 4.0 / 27;

} // namespace keiko::test
