#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/placement/best_view.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/open_scene.h"

namespace keiko {

/// The views of a body by other looks than its lamps', from their films, which have look_layers: of
/// each the Gaussian curvature, by one scale for all, with what the eye sees of the inflection
/// curves, and zebra.
std::vector<ReportPicture> curvature_pictures(std::span<const NamedView> views,
                                              std::span<const std::pair<std::string, Film>> films,
                                              const Inspection& inspection);

} // namespace keiko
