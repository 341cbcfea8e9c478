// The seam fixtures. Lengths are in mm.
//
// The seam c(v), v from 0 to 1, is a cubic in the plane x = 0 with Pythagorean hodograph,
//     c' = L (0, a^2 - b^2, 2ab).
//
// With a = 1 and b linear in v its speed L s, s = a^2 + b^2, is a polynomial. So is s n, the scaled
// unit normal of the curve in its plane. Across the seam the arc length is X = s xi to first order,
// with xi linear in u. The section in the plane of the x axis and n is
//     h(X) = k X^2 / 2 + t X^3 / 6.
//
// The surface c + X e + h(X) n is then polynomial. Its normal, its curvature k across the seam and
// the derivative t of that curvature are exact at every v.
#include "face_maker.h"
#include "fixtures.h"
#include <Geom_BezierSurface.hxx>
#include <Geom_Curve.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kLength = 200.0;
constexpr double kWidth = 100.0;
constexpr double kBend = 0.06;

/// One side of the seam: where it goes (-1 or 1 along x) and its section.
struct Side {
    double direction;
    double curvature;
    double curvature_slope = 0.0;
    /// Turns the section downwards about the seam, in radians.
    double tilt = 0.0;
    /// Moves the side along x.
    double shift = 0.0;
};

gp_XYZ seam_point(double v) {
    const double b = kBend * (1.0 - 2.0 * v);
    // Integrals of b and b^2 from 0 to v.
    const double once = kBend * (v - v * v);
    const double twice = (kBend * kBend * kBend - b * b * b) / (6.0 * kBend);
    return {0.0, kLength * (v - 0.5 - twice), kLength * 2.0 * once};
}

gp_XYZ side_point(const Side& side, double u, double v) {
    const double b = kBend * (1.0 - 2.0 * v);
    const double s = 1.0 + b * b;
    const gp_XYZ along_x(1.0, 0.0, 0.0);
    const gp_XYZ scaled_normal(0.0, -2.0 * b, 1.0 - b * b);
    // On the left u runs towards the seam, on the right away from it.
    const double xi = kWidth * (side.direction > 0.0 ? u : u - 1.0);
    const double x = s * xi;
    // h(X) / s, for s times the normal is what is polynomial.
    const double height =
        side.curvature * s * xi * xi / 2.0 + side.curvature_slope * s * s * xi * xi * xi / 6.0;
    const double cosine = std::cos(side.tilt);
    const double sine = std::sin(side.tilt);
    const gp_XYZ across =
        along_x * (x * cosine + height * s * sine) + scaled_normal * (height * cosine - xi * sine);
    return seam_point(v) + across + along_x * side.shift;
}

Handle(Geom_BezierSurface) side_surface(const Side& side) {
    return bezier_surface(
        polynomial_net(3, 6, [&](double u, double v) { return side_point(side, u, v); }));
}

/// Position, normal and curvature of the finished surface at a place of the seam.
struct SeamState {
    gp_XYZ position;
    gp_XYZ normal;
    double curvature;
    double curvature_slope;
};

/// The section v = const lies in the plane of x axis and normal, so its curvature as a plane curve
/// is the normal curvature across the seam.
SeamState state(const Handle(Geom_BezierSurface) & surface, double direction, double v) {
    const double u = direction > 0.0 ? 0.0 : 1.0;
    gp_Pnt position;
    gp_Vec du;
    gp_Vec dv;
    surface->D1(u, v, position, du, dv);
    const gp_Vec normal = du.Crossed(dv).Normalized();
    gp_Vec first;
    gp_Vec second;
    gp_Vec third;
    surface->VIso(v)->D3(u, position, first, second, third);
    const gp_Vec axis = normal.Crossed(first).Normalized().Reversed();
    const double speed = first.Magnitude();
    const double curvature = first.Crossed(second).Dot(axis) / std::pow(speed, 3.0);
    const double slope = first.Crossed(third).Dot(axis) / std::pow(speed, 4.0) -
                         3.0 * curvature * first.Dot(second) / std::pow(speed, 3.0);
    return {position.XYZ(), normal.XYZ(), curvature, slope};
}

/// The value of `measure` along the seam that is furthest from `promised`.
double worst(const std::array<Side, 2>& sides, double promised,
             const std::function<double(const SeamState&, const SeamState&)>& measure) {
    const Handle(Geom_BezierSurface) left = side_surface(sides[0]);
    const Handle(Geom_BezierSurface) right = side_surface(sides[1]);
    double result = promised;
    for (int k = 0; k <= 100; ++k) {
        const double v = k / 100.0;
        const double value = measure(state(left, -1.0, v), state(right, 1.0, v));
        if (std::abs(value - promised) >= std::abs(result - promised)) result = value;
    }
    return result;
}

double gap(const SeamState& a, const SeamState& b) {
    return (a.position - b.position).Modulus();
}

double angle_degrees(const SeamState& a, const SeamState& b) {
    const double sine = a.normal.Crossed(b.normal).Modulus();
    return std::atan2(sine, a.normal.Dot(b.normal)) * 180.0 / std::numbers::pi;
}

Fixture seam_fixture(const std::string& file, const std::array<Side, 2>& sides, double gap_promised,
                     double angle_promised) {
    const double jump = sides[1].curvature - sides[0].curvature;
    const double slope_jump = sides[1].curvature_slope - sides[0].curvature_slope;
    const auto curvature_jump = [](const SeamState& a, const SeamState& b) {
        return b.curvature - a.curvature;
    };
    const auto curvature_slope_jump = [](const SeamState& a, const SeamState& b) {
        return b.curvature_slope - a.curvature_slope;
    };
    return {
        file,
        {whole_face("left", side_surface(sides[0])), whole_face("right", side_surface(sides[1]))},
        {{"gap along the seam", "mm", gap_promised, worst(sides, gap_promised, gap), 1e-11},
         {"angle of the normals along the seam", "deg", angle_promised,
          worst(sides, angle_promised, angle_degrees), 1e-9},
         {"jump of the curvature across the seam", "1/mm", jump, worst(sides, jump, curvature_jump),
          1e-13},
         {"jump of that curvature's slope", "1/mm^2", slope_jump,
          worst(sides, slope_jump, curvature_slope_jump), 1e-14}}};
}

constexpr double kCurvature = -1.0 / 1000.0;

} // namespace

Fixture seam_g0_gap() {
    constexpr double kGap = 0.05;
    const Side left{.direction = -1.0, .curvature = kCurvature};
    const Side right{.direction = 1.0, .curvature = kCurvature, .shift = kGap};
    return seam_fixture("seam-g0-gap.step", {left, right}, kGap, 0.0);
}

Fixture seam_g1_angle() {
    constexpr double kAngle = 0.2;
    const Side left{.direction = -1.0, .curvature = kCurvature};
    const Side right{
        .direction = 1.0, .curvature = kCurvature, .tilt = kAngle * std::numbers::pi / 180.0};
    return seam_fixture("seam-g1-angle.step", {left, right}, 0.0, kAngle);
}

Fixture seam_g1_only() {
    const Side left{.direction = -1.0, .curvature = -1.0 / 1500.0};
    const Side right{.direction = 1.0, .curvature = kCurvature};
    return seam_fixture("seam-g1-only.step", {left, right}, 0.0, 0.0);
}

Fixture seam_g2_only() {
    const Side left{.direction = -1.0, .curvature = kCurvature};
    const Side right{.direction = 1.0, .curvature = kCurvature, .curvature_slope = -4e-6};
    return seam_fixture("seam-g2-only.step", {left, right}, 0.0, 0.0);
}

} // namespace keiko::fixtures
