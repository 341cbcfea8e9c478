#pragma once

namespace keiko {

/// What a seam is cut by.
struct StretchLimits {
    double feature_angle = 5; ///< degrees
    double negligible = 0.1;  ///< mm; a part shorter than this may be missed
    double join = 0.5;        ///< mm: pieces of one line are at most this far apart
    double angle = 0.1;       ///< degrees: a run-out ends where the angle falls to this
    double fading = 0.0014;   ///< degrees/mm: how large a step the slope of a fading angle may have
    double longest_run_out = 200; ///< mm: an angle that fades more slowly is none
};

} // namespace keiko
