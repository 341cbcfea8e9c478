#include "tests/support/defect_panel.h"

#include "keiko/base/units.h"

#include "tests/support/model_builder.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace keiko::test {
namespace {

constexpr double half_length = 500, half_width = 350; ///< mm
constexpr double dent_radius = 40, fade = 60;         ///< mm

double squared(double x) {
    return x * x;
}

/// 1 at 0, falling to 0 at 1 with three derivatives.
double bell(double square) {
    return square < 1 ? squared(squared(1 - square)) : 0;
}

double panel(double x, double y) {
    constexpr double along = 3000, across = 5000; // mm, radii
    return -x * x / (2 * along) - y * y / (2 * across);
}

/// Height that is added to the panel; `beyond` the seam only for defects of the seam.
double added(Defect defect, double size, bool beyond, double x, double y) {
    const double fading = beyond ? bell(squared(x / fade)) : 0;
    switch (defect) {
        case Defect::dent: {
            double depth = 0;
            for (const Vec3& p : places_of(defect))
                depth += bell((squared(x - p.x) + squared(y - p.y)) / squared(dent_radius));
            return -size * depth;
        }
        case Defect::wave:
            return size * std::cos(2 * std::numbers::pi * x / 100);
        case Defect::kink:
            return fading * std::tan(degrees_to_radians(size)) * x;
        case Defect::bend:
            return fading * size * 1e-3 * x * x / 2;
        case Defect::ramp:
            return fading * size * 1e-6 * x * x * x / 6;
    }
    return 0;
}

/// mm along x and y: as fine as the panel varies.
Vec2 span_for(Defect defect) {
    return defect == Defect::dent ? Vec2(10) : Vec2(2.5, 100);
}

/// Coefficients of the bicubic spline near a function on an even grid: exact for cubics (de Boor's
/// quasi-interpolant, -1/6, 8/6, -1/6 of three values).
NurbsSurface spline_of(const std::function<double(double, double)>& height, double x0, double x1,
                       const Vec2& span) {
    const int columns = static_cast<int>((x1 - x0) / span.x) + 3;
    const int rows = static_cast<int>(2 * half_width / span.y) + 3;
    const auto smooth = [](double a, double b, double c) { return (8 * b - a - c) / 6; };
    NurbsSurface surface{3, 3, {}, {}, {}};
    for (int i = 0; i < columns + 4; ++i) surface.knots_u.push_back(x0 + span.x * (i - 3));
    for (int j = 0; j < rows + 4; ++j) surface.knots_v.push_back(-half_width + span.y * (j - 3));
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const double x = x0 + span.x * (i - 1), y = -half_width + span.y * (j - 1);
            const auto along_y = [&](double at) {
                return smooth(height(at, y - span.y), height(at, y), height(at, y + span.y));
            };
            const double z = smooth(along_y(x - span.x), along_y(x), along_y(x + span.x));
            surface.points.emplace_back(x, y, z, 1);
        }
    return surface;
}

} // namespace

bool is_at_seam(Defect defect) {
    return defect == Defect::kink || defect == Defect::bend || defect == Defect::ramp;
}

std::array<Vec3, 9> places_of(Defect defect) {
    std::array<Vec3, 9> places;
    for (std::size_t k = 0; k < 9; ++k) {
        const bool at_seam = is_at_seam(defect);
        const double x = at_seam ? 0 : 300 * (double(k % 3) - 1);
        const double y = at_seam ? 70 * (double(k) - 4) : 200 * (double(k / 3) - 1);
        places[k] = Vec3(x, y, panel(x, y));
    }
    return places;
}

SurfaceModel defect_panel(Defect defect, double size) {
    ModelBuilder builder;
    for (const bool beyond : {false, true})
        builder.nurbs(spline_of(
            [&](double x, double y) { return panel(x, y) + added(defect, size, beyond, x, y); },
            beyond ? 0 : -half_length, beyond ? half_length : 0, span_for(defect)));
    return builder.build();
}

} // namespace keiko::test
