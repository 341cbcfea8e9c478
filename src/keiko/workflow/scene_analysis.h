#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/analysis_mode.h"
#include "keiko/workflow/open_scene.h"

namespace KEIKO_API keiko {

/// A mode of analysis pictures, with its settings.
struct ChosenMode {
    AnalysisMode look = AnalysisMode::zebra; ///< the mode
    AnalysisOptions options{};               ///< as given, else the defaults
    Vec3 section{0, 1, 0};                   ///< normal of the planes of sections
};

/// The analysis_picture() of a scene from a camera. `rig` has the lamps of highlight lines; other
/// modes do not read it.
Image scene_analysis(const Scene& scene, const Camera& camera, const LightRig& rig,
                     const ChosenMode& chosen, const Job& job = {});

} // namespace keiko
