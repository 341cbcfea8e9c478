#pragma once

namespace keiko {

/// Limits by which a seam is cut into stretches.
struct StretchLimits {
    double feature_angle = 5;     ///< degrees
    double negligible = 0.1;      ///< mm; a shorter part may be missed
    double join = 0.5;            ///< mm: largest distance between pieces of one line
    double angle = 0.1;           ///< degrees: a run-out ends where the angle falls to this
    double fading = 0.0014;       ///< degrees/mm: largest step of the slope of a fading angle
    double longest_run_out = 200; ///< mm: an angle that fades over a longer distance is no run-out
};

} // namespace keiko
