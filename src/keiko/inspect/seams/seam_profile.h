#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// The relation of both sides at one place of a profile.
struct ProfileSample {
    std::uint32_t piece = 0;          ///< number of the piece along the stretch, from 0
    double along = 0;                 ///< mm of side a from the beginning of the stretch
    SeamPoint point;                  ///< gap, angle, curvatures and their slopes
    double alias = 0, catia = 0;      ///< G2 by either formula, share of 1; 0 without an angle
    std::optional<double> mismatch{}; ///< G2 by the preset's formula; nullopt without an angle
    std::optional<double> slope{};    ///< G3, degrees; nullopt where it has none or is nearly flat
};

/// Share of a stretch's length, 0 to 1.
struct ProfileShare {
    double value = 0; ///< by straight lines between samples
    double bound = 0; ///< share of the steps that cross the limit or have an end without a value
};

/// One quantity along the whole of a stretch.
struct ProfileQuantity {
    double largest = 0; ///< value found, as that of the verdict
    double bound = 0;   ///< the exact largest lies within this of it
    Vec3 place{0};      ///< of the largest, world, mm
    double along = 0;   ///< of the largest, mm
    /// Limit of the preset for this class of stretch; nullopt for none, as for a scrap.
    std::optional<double> limit{};
    bool judged = false;   ///< it has a part in the verdict of the stretch
    ProfileShare beyond{}; ///< the limit; 0 without one
};

/// The quantities of a stretch of a seam from its one end to the other, whatever of it is judged:
/// curvatures are there even where gap or angle fail.
struct SeamProfile {
    std::uint32_t seam = 0;               ///< into the measured seams
    double length = 0;                    ///< mm of side a, without the distances between pieces
    std::vector<ProfileSample> samples;   ///< by `along`: ends and largest values of each piece too
    std::optional<ProfileQuantity> gap;   ///< G0, mm
    std::optional<ProfileQuantity> angle; ///< G1, degrees
    std::optional<ProfileQuantity> curvature; ///< G2, share of 1, by the preset's formula
    std::optional<ProfileQuantity> slope;     ///< G3, degrees
};

/// The profiles of these measured seams, indices into `seams`, in their order. Measure and largest
/// values are those of the verdicts. `pieces`: those of the seams, MeasuredSeams::pieces. Steps are
/// halved where a quantity leaves the chord of a step by a hundredth of its limit or its largest
/// value. Those that cross a limit are halved down to a thousandth of the length. A piece has at
/// most 200 samples more than steps.
std::vector<SeamProfile> seam_profiles(const ModelBorders& borders,
                                       std::span<const MeasuredSeam> seams,
                                       std::span<const Seam> pieces,
                                       std::span<const std::uint32_t> indices,
                                       const FaceLimits& limits, const Job& job = {});

} // namespace keiko
