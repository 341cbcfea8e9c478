#pragma once

#include "tests/support/model_builder.h"

#include <cmath>
#include <vector>

namespace keiko::test {

constexpr double sheet_length = 100; ///< mm along x

/// A piece of a cylinder about the line y = 0, z = `centre_z`, along x from 0 to sheet_length (u);
/// v runs over the angles, radians from +y towards +z.
inline std::vector<Vec4> arc_sheet(double centre_z, double radius, double from, double to) {
    const double w = std::cos((to - from) / 2), middle = (from + to) / 2;
    std::vector<Vec4> points;
    for (const double x : {0.0, sheet_length}) {
        const auto add = [&](double angle, double r, double weight) {
            points.emplace_back(x * weight, r * std::cos(angle) * weight,
                                (centre_z + r * std::sin(angle)) * weight, weight);
        };
        add(from, radius, 1);
        add(middle, radius / w, w);
        add(to, radius, 1);
    }
    return points;
}

/// A flat sheet from the x axis outwards along `across`; u runs along x.
inline void flat_sheet(ModelBuilder& builder, const Vec3& across, const Vec3& shift = Vec3(0)) {
    builder.plane(shift, {sheet_length, 0, 0}, across);
}

} // namespace keiko::test
