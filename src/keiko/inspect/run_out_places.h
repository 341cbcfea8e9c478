#pragma once

#include "keiko/inspect/class_stretches.h"

#include <map>
#include <span>
#include <vector>

namespace keiko {

/// The run-outs of creases among the seams of a model, found when they are asked for. Keeps
/// references.
class RunOutPlaces {
public:
    /// `chains`: of seam_chains.
    RunOutPlaces(const BoundaryCurves& curves, std::span<const Seam> seams,
                 const std::vector<std::vector<std::uint32_t>>& chains, const StretchLimits& limits)
        : curves_(curves), seams_(seams), chains_(chains), limits_(limits) {}

    /// Whether a place, world, mm, lies within `reach` mm of a run-out of a chain.
    bool hold(std::uint32_t chain, const Vec3& place, double reach);

private:
    const std::vector<SeamProbe>& run_outs_of(std::uint32_t chain);

    const BoundaryCurves& curves_;
    std::span<const Seam> seams_;
    const std::vector<std::vector<std::uint32_t>>& chains_;
    StretchLimits limits_;
    std::map<std::uint32_t, std::vector<SeamProbe>> found_;
};

} // namespace keiko
