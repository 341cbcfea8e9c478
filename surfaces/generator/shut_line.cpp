// A door beside a fender: two panels of a vehicle's right side, whose edges are rolled inwards and
// stand apart. Lengths are in mm; the joint runs upwards.
#include "face_maker.h"
#include "fixtures.h"
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kHeight = 600.0, kDepth = 250.0, kFlange = 12.0;
constexpr double kFenderRadius = 2.0, kDoorRadius = 3.0;
constexpr double kGap = 3.5;   // at the foot of the joint
constexpr double kFlush = 0.4; // the door stands out
constexpr double kTaper = 0.1 * std::numbers::pi / 180.0;
const gp_XYZ kOutward(0.0, 1.0, 0.0);

/// A straight panel whose skin ends in a line from `foot`.
struct PanelDesign {
    std::string name;
    gp_XYZ foot, up, forward; ///< forward: over the end of the skin
    double radius;
};

PanelDesign fender() {
    return {"fender", {0.0, 0.0, 300.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, kFenderRadius};
}

PanelDesign door() {
    const double sine = std::sin(kTaper), cosine = std::cos(kTaper);
    return {"door",
            {kFenderRadius + kGap + kDoorRadius, kFlush, 300.0},
            {sine, 0.0, cosine},
            {-cosine, 0.0, sine},
            kDoorRadius};
}

/// A profile moved up, u along the profile: the middle of three points is weighted as that of a
/// quarter arc is.
Handle(Geom_BezierSurface) risen(const std::vector<gp_XYZ>& profile, const gp_XYZ& up) {
    const int count = static_cast<int>(profile.size());
    TColgp_Array2OfPnt poles(1, count, 1, 2);
    TColStd_Array2OfReal weights(1, count, 1, 2);
    for (int i = 1; i <= count; ++i)
        for (int j = 1; j <= 2; ++j) {
            const gp_XYZ& point = profile[static_cast<std::size_t>(i - 1)];
            poles(i, j) = gp_Pnt(point + up * (kHeight * (j - 1)));
            weights(i, j) = count == 3 && i == 2 ? 0.5 * std::numbers::sqrt2 : 1.0;
        }
    return new Geom_BezierSurface(poles, weights);
}

/// The end of the roll at the foot: where the panel is foremost.
gp_XYZ foremost(const PanelDesign& panel) {
    return panel.foot + (panel.forward - kOutward) * panel.radius;
}

Handle(Geom_BezierSurface) roll(const PanelDesign& panel) {
    return risen({panel.foot, panel.foot + panel.forward * panel.radius, foremost(panel)},
                 panel.up);
}

void add_faces(const PanelDesign& panel, Fixture& fixture) {
    const gp_XYZ end = foremost(panel);
    const auto add = [&](const std::string& name, const Handle(Geom_BezierSurface) & surface) {
        NamedFace face = whole_face(panel.name + "-" + name, surface);
        if (panel.forward.Crossed(panel.up).Dot(kOutward) < 0.0) face.face.Reverse();
        fixture.faces.push_back(face);
    };
    add("skin", risen({panel.foot - panel.forward * kDepth, panel.foot}, panel.up));
    add("roll", roll(panel));
    add("flange", risen({end, end - kOutward * kFlange}, panel.up));
}

double radius_error(const PanelDesign& panel) {
    const Handle(Geom_BezierSurface) surface = roll(panel);
    double largest = 0.0;
    for (double u = 0.0; u <= 1.0; u += 0.25)
        for (double v = 0.0; v <= 1.0; v += 0.0625) {
            const gp_XYZ centre = panel.foot - kOutward * panel.radius + panel.up * (kHeight * u);
            const double distance = (surface->Value(v, u).XYZ() - centre).Modulus();
            largest = std::max(largest, std::abs(distance - panel.radius));
        }
    return largest;
}

/// Gap in the plane through a height of the fender's foremost line, square to the mean of both
/// lines, by the ends of the finished rolls.
double measured_gap(double height) {
    const Handle(Geom_BezierSurface) front = roll(fender()), rear = roll(door());
    const gp_XYZ at = front->Value(1.0, height / kHeight).XYZ();
    const gp_XYZ foot = rear->Value(1.0, 0.0).XYZ(), head = rear->Value(1.0, 1.0).XYZ();
    const gp_XYZ mean = fender().up + door().up;
    const double share = (at - foot).Dot(mean) / (head - foot).Dot(mean);
    gp_XYZ across = foot + (head - foot) * share - at;
    across -= kOutward * across.Dot(kOutward);
    return across.Modulus();
}

/// The lines meet below the foot at an angle of kTaper.
double promised_gap(double height) {
    const gp_XYZ rear = foremost(door());
    const double tip = rear.Z() - (rear.X() - kFenderRadius) / std::tan(kTaper);
    return 2.0 * std::tan(kTaper / 2.0) * std::cos(kTaper / 2.0) * (300.0 + height - tip);
}

} // namespace

Fixture shut_line() {
    Fixture fixture{"shut-line.step", {}, {}};
    add_faces(fender(), fixture), add_faces(door(), fixture);
    fixture.truths = {
        {"radius of the fender's roll, error", "mm", 0.0, radius_error(fender()), 1e-12},
        {"radius of the door's roll, error", "mm", 0.0, radius_error(door()), 1e-12},
        {"gap 100 mm above the foot", "mm", promised_gap(100.0), measured_gap(100.0), 1e-10},
        {"gap 500 mm above the foot", "mm", promised_gap(500.0), measured_gap(500.0), 1e-10}};
    return fixture;
}

} // namespace keiko::fixtures
