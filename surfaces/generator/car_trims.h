#pragma once

#include "car_panels.h"

#include <array>

namespace keiko::fixtures {

/// All trim curves of the car. What the body keeps of itself lies to the left of foot and arches.
struct CarTrims {
    /// Curve along which the greenhouse stands on the body: side 0 is the body, side 1 the
    /// greenhouse.
    TrimCurve greenhouse_foot;
    /// Front right, rear right, front left, rear left; circles in side view.
    std::array<TrimCurve, 4> wheel_arches;
    /// Lamps and grilles, on the body.
    std::vector<PanelCurve> body_panels;
    /// Glass and brake lamp, on the greenhouse.
    std::vector<PanelCurve> windows;
};

/// Middle of the right wheels (front, rear) and radius of their arches, in mm.
struct WheelPlace {
    double x;
    double z;
    /// How far the flank swings out around the arch, in mm per mm rearwards.
    double flank_slant;
};
inline constexpr std::array<WheelPlace, 2> kWheels{{{935.0, 312.5, 0.12}, {3660.0, 312.5, -0.09}}};
inline constexpr double kArchRadius = 345.0;

CarTrims car_trims(const Skin& body, const Skin& greenhouse);

/// Is the middle of the body's cell inside a wheel arch?
bool is_in_wheel_arch(const Skin& body, Cell cell);

} // namespace keiko::fixtures
