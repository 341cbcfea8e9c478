#pragma once

#include "keiko/inspect/seams/class_stretches.h"

#include <span>
#include <vector>

namespace keiko {

/// The run-outs of the creases of one seam.
class RunOutPlaces {
public:
    /// No run-outs.
    RunOutPlaces() = default;
    /// Run-outs of the seam's pieces, whose curves are kept.
    RunOutPlaces(std::span<const SeamProbe> pieces, const StretchLimits& limits);

    /// True if a place, world, mm, lies within `reach` mm of a run-out.
    bool hold(const Vec3& place, double reach) const;

private:
    std::vector<SeamProbe> run_outs_;
};

} // namespace keiko
