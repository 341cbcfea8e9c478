#include "circle_arc.h"
#include "face_maker.h"
#include "fixtures.h"
#include "skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kTop = 40.0;

/// Profile from the pole outwards: radius and height in mm. Level at the pole, so that the normal
/// there is the z axis although du vanishes.
struct ProfilePoint {
    double radius;
    double height;
};
constexpr std::array<ProfilePoint, 4> kProfile{{{0, kTop}, {50, kTop}, {100, 20}, {120, 0}}};

/// A quarter of the cap; the whole edge v = 0 is the pole.
Handle(Geom_BezierSurface) cap_quarter(int k) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    const auto arc = circle_arc(k * kQuarter, kQuarter);
    return bezier_surface(sample_net(kArcDegree + 1, 4, [&](int i, int j) {
        const gp_XY direction = arc[static_cast<std::size_t>(i)];
        const ProfilePoint point = kProfile[static_cast<std::size_t>(j)];
        return gp_XYZ(direction.X() * point.radius, direction.Y() * point.radius, point.height);
    }));
}

/// Angle in degrees between the z axis and the normal `v` away from the pole.
double tilt_near_pole(const Handle(Geom_BezierSurface) & surface, double v) {
    double largest = 0.0;
    for (double u = 0.0; u <= 1.0; u += 0.1) {
        gp_Pnt position;
        gp_Vec du;
        gp_Vec dv;
        surface->D1(u, v, position, du, dv);
        largest = std::max(largest, du.Crossed(dv).Angle(gp_Vec(0.0, 0.0, -1.0)));
    }
    return largest * 180.0 / std::numbers::pi;
}

double collapse(const Handle(Geom_BezierSurface) & surface) {
    double largest = 0.0;
    for (double u = 0.0; u <= 1.0; u += 0.1)
        largest = std::max(largest, surface->Value(u, 0.0).Distance(gp_Pnt(0.0, 0.0, kTop)));
    return largest;
}

} // namespace

Fixture pole() {
    Fixture fixture{"pole.step", {}, {}};
    double off_pole = 0.0;
    double tilt = 0.0;
    for (int k = 0; k < 4; ++k) {
        const Handle(Geom_BezierSurface) surface = cap_quarter(k);
        fixture.faces.push_back(whole_face("cap-" + std::to_string(k), surface));
        off_pole = std::max(off_pole, collapse(surface));
        tilt = std::max(tilt, tilt_near_pole(surface, 1e-9));
    }
    fixture.truths = {{"collapsed edge to the pole (0, 0, 40)", "mm", 0.0, off_pole, 1e-12},
                      {"normal to the z axis at the pole", "deg", 0.0, tilt, 1e-6}};
    return fixture;
}

} // namespace keiko::fixtures
