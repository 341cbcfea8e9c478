#pragma once

namespace keiko {

/// How an eye sees a place of a body.
struct LineOfSight {
    double distance = 0; ///< mm, from the eye to the place
    double cosine = 0;   ///< between the line and the normal, 0 to 1
};

/// Arc minutes: width of the reflected lamp from the place of the body, a tube of 60 mm at 2 m.
constexpr double lamp_width = 103.1;

/// Arc minutes by which the reflection of a distant lamp is torn apart where the normal turns by
/// `angle` degrees, seen from the eye: 2 a / (1 + 2 |k| d / c). `curvature` in 1/mm, across the
/// tear. 0 at grazing incidence. Derivation: docs/theory/triage.md.
double break_of_angle(double angle, double curvature, const LineOfSight& sight);

/// Arc minutes by which the width of the reflection of a lamp of `lamp_width` changes where the
/// curvature across it jumps from `a` to `b`, 1/mm.
double break_of_curvatures(double a, double b, const LineOfSight& sight);

/// Arc minutes of a gap of `gap` mm, seen squarely.
double break_of_gap(double gap, const LineOfSight& sight);

} // namespace keiko
