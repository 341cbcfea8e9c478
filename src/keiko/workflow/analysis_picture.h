#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/camera.h"
#include "keiko/workflow/analysis_mode.h"

#include <vector>

namespace KEIKO_API keiko {

/// The layers of a film that a mode needs. Those of a curvature suffice for stripes and draft.
std::vector<Aov> look_layers(AnalysisMode look);

/// The display picture of a film's surface, with a legend if colours represent numbers. Curvatures
/// are positive in hollows as viewed from the camera; their colours are saturated at the ends of
/// the scale, by default of the 98th percentile of sizes, rounded up. Radii are
/// on a logarithmic scale. Stripes are averaged over
/// pixels. Highlight bands are as wide as the gaps between them; a surface whose normal meets no
/// C-plane of the rig is grey. Draft angles are those of the side that is seen.
Image analysis_picture(AnalysisMode look, const Film& film, const Camera& camera,
                       const LightRig& rig, const AnalysisOptions& options = {});

/// The round curvature, 1/mm or 1/mm2, that 2 % of the body's picture exceed.
double usual_curvature(AnalysisMode look, const Film& film, const Camera& camera);

} // namespace keiko
