#pragma once

#include <gp_XY.hxx>

#include <array>

namespace keiko::fixtures {

inline constexpr int kArcDegree = 5;

/// Control points of an arc of the unit circle from `start` over `sweep` (radians): the quintic
/// that has the circle's position, velocity and acceleration at both ends. Three thirds close with
/// C2 and leave the circle by 1.4e-4 of the radius at most.
std::array<gp_XY, kArcDegree + 1> circle_arc(double start, double sweep);

} // namespace keiko::fixtures
