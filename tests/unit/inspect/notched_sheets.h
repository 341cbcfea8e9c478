// Two sheets that meet in y = 0, with notches and holes at the seam.
#pragma once

#include "keiko/base/units.h"

#include "tests/support/model_builder.h"

#include <cmath>
#include <vector>

namespace keiko::test::notched {

constexpr double length = 100, depth = 50; ///< mm of either sheet, along x and y

/// A sheet below y = 0 whose upper border runs through `border`, from x = length to 0.
inline void notched_sheet(ModelBuilder& builder, const std::vector<Vec2>& border) {
    builder.plane({0, -depth, 0}, {length, 0, 0}, {0, depth + 1, 0});
    std::vector<Vec2> corners{{0, 0}, {1, 0}};
    for (const Vec2& p : border) corners.emplace_back(p.x / length, (p.y + depth) / (depth + 1));
    builder.polygon(corners);
}

inline void whole_sheet(ModelBuilder& builder) {
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, depth, 0});
}

/// Both ends of the seam, and what lies between.
inline std::vector<Vec2> bordered(const std::vector<Vec2>& between) {
    std::vector<Vec2> border{{length, 0}};
    border.insert(border.end(), between.begin(), between.end());
    border.emplace_back(0, 0);
    return border;
}

/// A sheet that goes up from y = 0 at `angle` degrees to the lower one, whose lower border runs
/// through `border`: x and mm up along it, from x = 0 to length.
inline void bent_sheet(ModelBuilder& builder, double angle, const std::vector<Vec2>& border) {
    const double a = degrees_to_radians(angle);
    builder.plane({0, 0, 0}, {length, 0, 0}, Vec3(0, -std::cos(a), std::sin(a)) * depth);
    std::vector<Vec2> corners{{0, 0}};
    for (const Vec2& p : border) corners.emplace_back(p.x / length, p.y / depth);
    corners.insert(corners.end(), {{1, 0}, {1, 1}, {0, 1}});
    builder.polygon(corners);
}

/// A hole of both sheets: `lower` from right to left, `upper` from left to right.
inline SurfaceModel holed_model(const std::vector<Vec2>& lower, const std::vector<Vec2>& upper,
                                double angle = 180) {
    ModelBuilder builder;
    notched_sheet(builder, bordered(lower));
    bent_sheet(builder, angle, upper);
    return builder.build();
}

inline SurfaceModel notched_model(const std::vector<Vec2>& between) {
    ModelBuilder builder;
    whole_sheet(builder);
    notched_sheet(builder, bordered(between));
    return builder.build();
}

} // namespace keiko::test::notched
