#pragma once

#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/seams/seam_partition.h"

#include <functional>
#include <span>
#include <vector>

namespace keiko {

/// A maximal part of a seam that is all of one class; it consists of one or more pieces of the
/// seam.
struct SeamStretch {
    SeamClass kind = SeamClass::smooth; ///< class of all its parts
    std::vector<SeamPart> parts;        ///< in the order of the seam's pieces
    double length = 0;                  ///< mm
    bool scrap = false;                 ///< shorter than the negligible length of the limits
    bool unknown = false; ///< a side has no normal for more than the negligible length
    /// Worst step of the angle's slope of a crease that fades out, degrees/mm.
    std::optional<MeasuredValue> fading;
};

/// Makes the pieces of other lines that go on at the ends of a line (ContinuingLines).
using PiecesBeyond = std::function<std::vector<SeamProbe>()>;

/// Cuts the pieces of a seam into stretches, by their first parts. The smooth part beside a crease
/// becomes a run-out as far as its angle fades to the limit, if it is no longer than the crease.
/// Where it is longer, creases on the pieces `beyond` that continue it count too.
std::vector<SeamStretch> seam_stretches(std::span<const SeamProbe> probes,
                                        const StretchLimits& limits,
                                        const PiecesBeyond& beyond = {});

/// The run-outs of the creases of one seam.
class RunOutPlaces {
public:
    /// No run-outs.
    RunOutPlaces() = default;
    /// Run-outs of the seam's pieces, whose curves are kept.
    RunOutPlaces(std::span<const SeamProbe> pieces, const StretchLimits& limits,
                 const PiecesBeyond& beyond = {});

    /// True if a place, world, mm, lies within `reach` mm of a run-out.
    bool hold(const Vec3& place, double reach) const;

private:
    std::vector<SeamProbe> run_outs_;
};

} // namespace keiko
