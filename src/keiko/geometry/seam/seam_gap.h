#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"

#include <vector>

namespace keiko {

/// The gap between a trim curve and the border of the neighbour that shares its edge. A file's edge
/// tolerance only claims its size, and is often far too large or far too small; here it is
/// measured. All lengths in mm, part coordinates.
struct SeamGap {
    /// Largest distance beyond the border that belongs to the seam; wider gaps by the samples stay
    /// open. 0: a curve without an edge.
    double width = 0;
    double touch = 0; ///< a line within this distance touches the border
    /// The gap at one place of the curve.
    struct Sample {
        Vec3 border{0}; ///< place of the curve
        Vec3 across{0}; ///< from there to the nearest place of the neighbour's border
    };
    /// Samples at equal steps of t from 0 to 1. Empty if the gap is negligible or wider than join,
    /// if there is not exactly one neighbour, or if the samples miss more than half of the gap.
    std::vector<Sample> samples;

    /// True if a line of sight passes between both borders within the width, or touches the border.
    /// `off` is the vector from the border at `t` to the line, which passes beyond it, and
    /// `direction` the line's. At the curve's ends, where several seams meet, the width alone
    /// decides.
    bool holds(double t, const Vec3& off, const Vec3& direction) const;
};

/// Gaps of a model, one for each trim curve. An edge without a neighbour keeps the file's
/// tolerance. No gap wider than `join` is sealed. A gap wider than both the file's tolerance and
/// 1e-5 of the part is sealed only as far as the file claims.
std::vector<SeamGap> seam_gaps(const SurfaceModel& model, double join, const Job& job);

} // namespace keiko
