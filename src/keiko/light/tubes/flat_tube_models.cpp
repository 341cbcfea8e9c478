#include "keiko/light/tubes/flat_tube_models.h"

#include "keiko/light/luminance/line_irradiance.h"
#include "keiko/light/luminance/polygon_irradiance.h"

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Corners relative to the point, in circulation, both long sides parallel to the axis.
std::array<Vec3, 4> strip_corners(const TubeView& view, double begin, double end,
                                  double half_width) {
    const Vec3 foot = view.towards * -view.distance, side = view.sideways * half_width;
    const Vec3 a = foot + view.along * begin, b = foot + view.along * end;
    return {a - side, b - side, b + side, a + side};
}

double strip(const TubeView& view, double begin, double end, double half_width) {
    return projected_solid_angle(strip_corners(view, begin, end, half_width), Vec3(0), view.normal);
}

LinePiece piece_of(const TubeView& view, const VisiblePart& part) {
    return {part.begin, part.end, view.distance, view.n_along, view.n_lamp};
}

} // namespace

double seed_solid_angle(const TubeView& view, const VisiblePart& part) {
    const LinePiece axis = above_horizon(piece_of(view, part));
    if (!(axis.begin < axis.end)) return 0;
    const auto corners = strip_corners(view, axis.begin, axis.end, view.radius);
    const double long_side = angle_between(corners[0], corners[1]);
    const double width = 2 * view.radius;
    const std::array<double, 4> angles{long_side, width / corners[1].length(), long_side,
                                       width / corners[0].length()};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 plane = corners[i].cross(corners[(i + 1) % 4]);
        sum += angles[i] * view.normal.dot(plane) / plane.length();
    }
    return std::abs(sum) / 2;
}

double rectangle_solid_angle(const TubeView& view, const VisiblePart& part) {
    return strip(view, part.begin, part.end, view.radius);
}

double strip_solid_angle(const TubeView& view, const VisiblePart& part) {
    const double bulge = std::numbers::pi / 4 * view.radius;
    const double stretch = view.distance / (view.distance - bulge);
    const double sine = view.radius / view.distance;
    const double half_width = view.radius / std::sqrt((1 - sine) * (1 + sine));
    return strip(view, part.begins ? part.begin * stretch : part.begin,
                 part.ends ? part.end * stretch : part.end, half_width);
}

double line_solid_angle(const TubeView& view, const VisiblePart& part) {
    const LinePiece axis = above_horizon(piece_of(view, part));
    if (!(axis.begin < axis.end)) return 0;
    return 2 * view.radius * cosine_line_integral(axis);
}

} // namespace keiko
