#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/placement/best_view.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/open_scene.h"

namespace keiko {

/// Analysis pictures of a body, from the films of its views, which have look_layers. Each view has
/// two pictures: the Gaussian curvature, by one scale for all, with the visible inflection curves,
/// and zebra.
std::vector<ReportPicture> curvature_pictures(std::span<const NamedView> views,
                                              std::span<const std::pair<std::string, Film>> films,
                                              const Inspection& inspection);

} // namespace keiko
