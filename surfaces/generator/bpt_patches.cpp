#include "face_maker.h"
#include "fixtures.h"
#include "skin.h"

#include <algorithm>
#include <cmath>

namespace keiko::fixtures {
namespace {

constexpr double kHalfSize = 100.0;

using Height = double (*)(double x, double y);

/// z = (x^2 - y^2) / 400: Gaussian curvature -1 / 200^2 in the middle.
double saddle_height(double x, double y) {
    return (x * x - y * y) / 400.0;
}

/// A bell over a square: 50 mm high in the middle, 0 along the border.
double dome_height(double x, double y) {
    const double across = 1.0 - x * x / (kHalfSize * kHalfSize);
    const double along = 1.0 - y * y / (kHalfSize * kHalfSize);
    return 50.0 * across * along;
}

/// The quarter with the lower corner (x0, y0), as a patch.
Net quarter(int degree_u, int degree_v, Height height, double x0, double y0) {
    return polynomial_net(degree_u, degree_v, [&](double u, double v) {
        const double x = x0 + kHalfSize * u;
        const double y = y0 + kHalfSize * v;
        return gp_XYZ(x, y, height(x, y));
    });
}

double largest_height_error(const std::vector<Net>& patches, Height height) {
    double largest = 0.0;
    for (const Net& net : patches)
        for (double u = 0.0; u <= 1.0; u += 0.125)
            for (double v = 0.0; v <= 1.0; v += 0.125) {
                const gp_Pnt p = bezier_surface(net)->Value(u, v);
                largest = std::max(largest, std::abs(p.Z() - height(p.X(), p.Y())));
            }
    return largest;
}

BptFixture quarters(const std::string& file, int degree_u, int degree_v, Height height) {
    BptFixture fixture{file, {}, {}};
    for (const double x0 : {-kHalfSize, 0.0})
        for (const double y0 : {-kHalfSize, 0.0})
            fixture.patches.push_back(quarter(degree_u, degree_v, height, x0, y0));
    fixture.truths = {
        {"patches", "", 4.0, static_cast<double>(fixture.patches.size()), 0.0},
        {"height error", "mm", 0.0, largest_height_error(fixture.patches, height), 1e-11}};
    return fixture;
}

} // namespace

BptFixture saddle() {
    return quarters("saddle.bpt", 2, 2, saddle_height);
}
BptFixture dome() {
    return quarters("dome.bpt", 3, 5, dome_height);
}

} // namespace keiko::fixtures
