#pragma once

#include "keiko/inspect/seam_partition.h"
#include "keiko/inspect/worst.h"

#include <span>
#include <vector>

namespace keiko {

/// A maximal part of a seam that is all of one class; of one or more pieces of the seam.
struct SeamStretch {
    SeamClass kind = SeamClass::smooth;
    std::vector<SeamPart> parts; ///< in the order of the seam's pieces
    double length = 0;           ///< mm
    bool scrap = false;          ///< shorter than what the limits call negligible
    bool unknown = false;        ///< a side has no normal for more than is negligible
    /// Of a crease that fades out: the worst step of its angle's slope, degrees/mm.
    std::optional<Worst> fading;
};

/// What a seam is cut by.
struct StretchLimits {
    double feature_angle = 5; ///< degrees
    double negligible = 0.1;  ///< mm
    double join = 0.5;        ///< mm: ends of pieces as near as this go on into each other
    double angle = 0.1;       ///< degrees: a run-out ends where the angle falls to this
    double fading = 0.0014;   ///< degrees/mm: how large a step the slope of a fading angle may have
    double longest_run_out = 200; ///< mm: an angle that fades more slowly is none
};

/// The worse of two: by verdict, then by the largest value that it may have.
const Worst& worse_of(const Worst& a, const Worst& b);

/// Cuts the pieces of a seam into stretches, by their first parts. The smooth part beside a crease
/// becomes a run-out as far as its angle fades to the limit, if it is no longer than the crease.
std::vector<SeamStretch> seam_stretches(std::span<const SeamProbe> probes,
                                        const StretchLimits& limits);

} // namespace keiko
