#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/combs/comb_curves.h"
#include "keiko/report/content/combs_text.h"

#include <string>
#include <vector>

namespace keiko {

/// Curves with their curvature all along, prepared for files.
struct Combs {
    std::vector<CombCurve> curves;
    std::vector<std::string> remarks; ///< on planes that miss the body, touch it or contain faces
    std::string json, csv;
    std::vector<CombPicture> pictures;
};

/// True if the options request any curve.
bool has_curves(const CombOptions& options);
/// The sections and iso-curves of a body.
Combs combs_of(const SurfaceModel& model, const CombOptions& options, const Job& job = {});

} // namespace keiko
