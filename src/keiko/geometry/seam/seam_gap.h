#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"

#include <vector>

namespace keiko {

/// What is open between a trim curve and the border of the neighbour that shares its edge. A file's
/// edge tolerance only claims how much that is, and is often far too large or far too small; here
/// it is measured. All lengths in mm, part coordinates.
struct SeamGap {
    /// Farther beyond the border nothing belongs to the seam; what is wider by the samples is
    /// left open. 0: a curve without an edge.
    double width = 0;
    double touch = 0; ///< a line no farther off touches the border
    /// At equal steps of t from 0 to 1: the border, and the way from it to the neighbour's border.
    /// Empty where the gap is next to nothing or wider than join, or there is not just one
    /// neighbour.
    struct Sample {
        Vec3 border{0}, across{0};
    };
    std::vector<Sample> samples;

    /// Whether a line of sight passes between both borders, no farther off than the width: `off`
    /// is the way from the border at `t` to the line, which passes beyond it, and `direction` the
    /// line's; or touches the border. At the curve's ends, where several seams meet, the width
    /// alone decides.
    bool holds(double t, const Vec3& off, const Vec3& direction) const;
};

/// One for each trim curve. An edge without a neighbour keeps the file's tolerance. No gap is
/// sealed that is wider than `join`, nor one that is wider than both the file's tolerance and 1e-5
/// of the part: only so much of it as the file claims.
std::vector<SeamGap> seam_gaps(const SurfaceModel& model, double join, const Job& job);

} // namespace keiko
