#pragma once

#include "keiko/inspect/seams/seam_quantities.h"
#include "keiko/inspect/seams/stretch_probes.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A quantity that a profile is sampled for.
struct SampledQuantity {
    SeamQuantity value;
    double tolerance = 0;          ///< how far it may leave the chord of a step
    std::optional<double> limit{}; ///< whose crossings are found
};

/// The first samples of a piece of a seam, by rising parameter: steps that resolve the quantities,
/// and the places of the extremes.
std::vector<SeamPoint> first_samples(const SeamProbe& probe, const StretchExtremes& extremes);

/// Samples with those between them that the quantities need. Steps are halved, round by round,
/// where a quantity leaves their chord. Those that cross a limit are halved if they are longer than
/// `shortest` mm. 200 samples are added at most.
std::vector<SeamPoint> refined_samples(const SeamProbe& probe, std::vector<SeamPoint> samples,
                                       std::span<const SampledQuantity> quantities,
                                       double shortest);

} // namespace keiko
