#pragma once

#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/seams/seam_partition.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The end of a crease, along which its angle fades from the feature angle to the angle's limit.
struct RunOut {
    /// A part that it occupies, as a whole or, of its last part, from one end.
    struct Piece {
        std::size_t part = 0;         ///< into the parts of the seam
        SeamPart taken;               ///< what it occupies of that part, of class run-out
        std::optional<SeamPart> left; ///< the remainder of the part, of its former class
    };
    std::vector<Piece> pieces; ///< none where the angle falls to the limit at once
    MeasuredValue step;        ///< of the angle's slope, degrees/mm

    /// mm along the seam.
    double length() const {
        double sum = 0;
        for (const Piece& piece : pieces) sum += piece.taken.length;
        return sum;
    }
};

/// Follows the angle from one end of a crease through the smooth parts beyond it. `parts` are all
/// parts of the seam, `crease` the index of one; `forward` names its end in the order of side a.
/// Returns nullopt if no smooth part follows, or if the angle does not fade. It does not if it
/// rises by more than its limit, runs on for longer than the limits allow or is over its limit at
/// the seam's end.
/// A corner ends the seam: a turn of more than seam_corner within four negligible lengths. The
/// slope's step is searched where patches and pieces end. It uses mean slopes over once and twice
/// the negligible length, extrapolated to zero length on each side. Beyond the seam's own end the
/// angle counts as its value there.
std::optional<RunOut> follow_run_out(std::span<const SeamProbe> probes,
                                     std::span<const SeamPart> parts, std::size_t crease,
                                     bool forward, const StretchLimits& limits);

} // namespace keiko
