#include "face_maker.h"
#include "fixtures.h"
#include <Geom_Curve.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko::fixtures {
namespace {

constexpr int kDegree = 5;
constexpr int kColumns = 3;
constexpr int kRows = 14;

/// Right half of the control section, from the middle outwards, in mm: distance from the middle
/// and height of the power dome. Rows stand close together where the character line runs, which
/// makes it crisp, and everywhere in even steps, which keeps it soft.
struct SectionPoint {
    double y;
    double dome;
};
constexpr std::array<SectionPoint, 10> kSection{{{0, 26},
                                                 {170, 26},
                                                 {270, 26},
                                                 {315, 25.5},
                                                 {338, 13},
                                                 {361, 0.5},
                                                 {410, 0},
                                                 {560, 0},
                                                 {780, 0},
                                                 {1040, 0}}};

/// The hood at control station i: x rearwards, height of its middle and of the dome on it (share),
/// and how far the lines have spread.
struct Station {
    double x;
    double z;
    double dome;
    double spread;
};
constexpr std::array<Station, kColumns + kDegree> kStations{{{-760, 480, 0.45, 0.74},
                                                             {-380, 595, 0.60, 0.80},
                                                             {0, 690, 0.73, 0.855},
                                                             {380, 765, 0.84, 0.905},
                                                             {760, 820, 0.93, 0.95},
                                                             {1140, 855, 1.00, 0.99},
                                                             {1520, 870, 1.05, 1.025},
                                                             {1900, 865, 1.08, 1.055}}};

gp_XYZ control_point(int i, int j) {
    constexpr double kCrownRadius = 2600.0;
    constexpr int kMiddle = (kRows + kDegree) / 2;
    const Station& station = kStations[static_cast<std::size_t>(i)];
    const SectionPoint& section = kSection[static_cast<std::size_t>(std::abs(j - kMiddle))];
    const double y = section.y * station.spread * (j < kMiddle ? -1.0 : 1.0);
    const double crown = y * y / (2.0 * kCrownRadius);
    return {station.x, y, station.z - crown + section.dome * station.dome};
}

/// The tightest convex place of the section x = 570 (the middle) on the right: the character line.
struct CharacterLine {
    double y;
    double radius;
};

CharacterLine character_line(const Handle(Geom_Surface) & whole) {
    const Handle(Geom_Curve) section = whole->UIso(0.5 * kColumns);
    CharacterLine line{0.0, 1e9};
    for (double v = 0.5 * kRows; v <= kRows; v += 1e-4) {
        gp_Pnt p;
        gp_Vec first;
        gp_Vec second;
        section->D2(v, p, first, second);
        const double bend = first.Z() * second.Y() - first.Y() * second.Z();
        const double radius = std::pow(first.Magnitude(), 3.0) / bend;
        if (bend > 0.0 && radius < line.radius) line = {p.Y(), radius};
    }
    return line;
}

} // namespace

Fixture hood() {
    const UniformSpline spline{kDegree, kDegree,
                               sample_net(kColumns + kDegree, kRows + kDegree, control_point)};
    const auto part = [&](int v0, int v1) { return spline_surface(spline, 0, kColumns, v0, v1); };
    const CharacterLine line = character_line(part(0, kRows));
    return {"hood.step",
            {whole_face("wing-left", part(0, 2)), whole_face("dome", part(2, 12)),
             whole_face("wing-right", part(12, kRows))},
            {{"character line at half length: |y|", "mm", 296.185, line.y, 0.01},
             {"its smallest radius across", "mm", 90.44, line.radius, 0.01}}};
}

} // namespace keiko::fixtures
