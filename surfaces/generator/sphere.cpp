#include "face_maker.h"
#include "fixtures.h"
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kRadius = 100.0;

/// A quarter of the unit circle as a rational quadratic: ends and corner, middle weight 1/sqrt 2.
constexpr std::array<std::array<double, 2>, 3> kQuarter{{{1, 0}, {1, 1}, {0, 1}}};

double weight(int k) {
    return k == 1 ? 0.5 * std::numbers::sqrt2 : 1.0;
}

/// One octant: u turns about the z axis from quadrant `turn`, v rises from the equator to the pole
/// on the side of `sign`.
Handle(Geom_BezierSurface) octant(int turn, double sign) {
    TColgp_Array2OfPnt poles(1, 3, 1, 3);
    TColStd_Array2OfReal weights(1, 3, 1, 3);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const auto& around = kQuarter[static_cast<std::size_t>(i)];
            const auto& upwards = kQuarter[static_cast<std::size_t>(j)];
            double x = around[0] * upwards[0];
            double y = around[1] * upwards[0];
            for (int k = 0; k < turn; ++k) {
                std::swap(x, y);
                x = -x;
            }
            poles(i + 1, j + 1) = gp_Pnt(x * kRadius, y * kRadius, sign * upwards[1] * kRadius);
            weights(i + 1, j + 1) = weight(i) * weight(j);
        }
    return new Geom_BezierSurface(poles, weights);
}

double radius_error(const Handle(Geom_BezierSurface) & surface) {
    double largest = 0.0;
    for (double u = 0.0; u <= 1.0; u += 0.0625)
        for (double v = 0.0; v <= 1.0; v += 0.0625)
            largest = std::max(largest, std::abs(surface->Value(u, v).XYZ().Modulus() - kRadius));
    return largest;
}

} // namespace

Fixture sphere() {
    Fixture fixture{"rational-sphere.step", {}, {}};
    double error = 0.0;
    for (const double sign : {1.0, -1.0})
        for (int turn = 0; turn < 4; ++turn) {
            const Handle(Geom_BezierSurface) surface = octant(turn, sign);
            const std::string half = sign > 0.0 ? "north-" : "south-";
            NamedFace face = whole_face(half + std::to_string(turn), surface);
            // Below the equator v runs down, so du x dv points inwards.
            if (sign < 0.0) face.face.Reverse();
            fixture.faces.push_back(face);
            error = std::max(error, radius_error(surface));
        }
    fixture.truths = {{"radius 100 mm, error", "mm", 0.0, error, 1e-12}};
    return fixture;
}

} // namespace keiko::fixtures
