// Two sheets that meet in a seam along y at x = 0, with a defect that fades along it.
#pragma once

#include "tests/support/model_builder.h"
#include "tests/unit/inspect/bernstein.h"

#include <vector>

namespace keiko::test {

/// Difference of the right one of two sheets from the left one where they meet, at `defect_place`;
/// it fades away along the seam by the square of the way from there.
struct FadingDefect {
    double gap = 0;       ///< mm
    double slope = 0;     ///< tangent of the angle
    double curvature = 0; ///< 1/mm
    double change = 0;    ///< of the curvature, 1/mm2
};

constexpr double defect_length = 100;  ///< mm, of each sheet either way
constexpr double defect_place = 37;    ///< mm along the seam, where it is largest
constexpr double defect_radius = 1000; ///< mm, of the left sheet

/// z = curvature x^2 / 2 + h(y) (gap + slope x + curvature x^2 / 2 + change x^3 / 6) from x = begin
/// on, h = 1 at `defect_place`.
inline void add_sheet(ModelBuilder& builder, double begin, double bend,
                      const FadingDefect& defect) {
    const auto fading =
        bernstein<3>({1 - defect_place * defect_place / 1e4, 2 * defect_place / 1e4, -1 / 1e4}, 0,
                     defect_length);
    const auto base = bernstein<4>({0, 0, bend / 2, 0}, begin, defect_length);
    const auto more = bernstein<4>(
        {defect.gap, defect.slope, defect.curvature / 2, defect.change / 6}, begin, defect_length);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            points.emplace_back(begin + defect_length * double(i) / 3,
                                defect_length * double(j) / 2, base[i] + fading[j] * more[i]);
    builder.patch(3, 2, points);
}

} // namespace keiko::test
