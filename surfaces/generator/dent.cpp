#include "face_maker.h"
#include "fixtures.h"

#include <algorithm>
#include <cmath>

namespace keiko::fixtures {
namespace {

constexpr int kSpans = 20;
constexpr int kDegree = 5;
/// Knot distance in mm: the panel measures 400 mm, the dent 120 mm.
constexpr double kStep = 20.0;
constexpr double kHalfSize = 0.5 * kSpans * kStep;
constexpr double kRadiusX = 2500.0;
constexpr double kRadiusY = 1500.0;

constexpr double kDepth = 0.1;
constexpr double kDentX = 40.0;
constexpr double kDentY = -20.0;
/// Share of a control point in a quintic uniform spline right under it.
constexpr double kPeakWeight = 66.0 / 120.0;

double panel_height(double x, double y) {
    return -x * x / (2.0 * kRadiusX) - y * y / (2.0 * kRadiusY);
}

/// The spline of a net that samples x^2 / 2R at distance d lies d^2 / 4R higher than x^2 / 2R
/// (quintic: the basis has variance 1/2). Taken off, the surface is the paraboloid itself.
double net_height(double x, double y) {
    const double lift = -kStep * kStep / 4.0 * (1.0 / kRadiusX + 1.0 / kRadiusY);
    return panel_height(x, y) - lift;
}

UniformSpline dented_panel() {
    const auto place = [](int k) { return (k - 2) * kStep - kHalfSize; };
    return {kDegree, kDegree, sample_net(kSpans + kDegree, kSpans + kDegree, [&](int i, int j) {
                const double x = place(i);
                const double y = place(j);
                const bool dented = x == kDentX && y == kDentY;
                const double dent = dented ? kDepth / (kPeakWeight * kPeakWeight) : 0.0;
                return gp_XYZ(x, y, net_height(x, y) - dent);
            })};
}

/// How far the surface at (x, y) lies below the panel without dent, in mm.
double depth(const Handle(Geom_Surface) & surface, double x, double y) {
    const gp_Pnt p = surface->Value((x + kHalfSize) / kStep, (y + kHalfSize) / kStep);
    return panel_height(p.X(), p.Y()) - p.Z();
}

/// Distance along x from the deepest place at which the dent is half as deep, in mm.
double half_depth_radius(const Handle(Geom_Surface) & surface) {
    double inside = 0.0;
    double outside = 3.0 * kStep;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (inside + outside);
        (depth(surface, kDentX + middle, kDentY) > 0.5 * kDepth ? inside : outside) = middle;
    }
    return inside;
}

double largest_depth_outside(const Handle(Geom_Surface) & surface) {
    double largest = 0.0;
    for (double x = -kHalfSize; x <= kHalfSize; x += 5.0)
        for (double y = -kHalfSize; y <= kHalfSize; y += 5.0)
            if (std::abs(x - kDentX) >= 3.0 * kStep || std::abs(y - kDentY) >= 3.0 * kStep)
                largest = std::max(largest, std::abs(depth(surface, x, y)));
    return largest;
}

} // namespace

Fixture dent() {
    const Handle(Geom_Surface) surface = spline_surface(dented_panel(), 0, kSpans, 0, kSpans);
    constexpr double kHalfDepthRadius = 17.3218;
    return {"dent.step",
            {whole_face("panel", surface)},
            {{"depth along z at (40, -20)", "mm", kDepth, depth(surface, kDentX, kDentY), 1e-12},
             {"depth beyond 60 mm in x or y", "mm", 0.0, largest_depth_outside(surface), 1e-12},
             {"half depth at this distance along x", "mm", kHalfDepthRadius,
              half_depth_radius(surface), 1e-3}}};
}

} // namespace keiko::fixtures
