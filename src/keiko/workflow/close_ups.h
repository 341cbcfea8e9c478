#pragma once

#include "keiko/base/job.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/open_scene.h"

#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// Close-up pictures, `most` of them at most. What the first screen shows comes first. Then come,
/// in turn, the worst seams, faces and crossings of lines that do not pass, and faces that deserve
/// a look. Each is from the view that shows its place most squarely, or else from a standing one;
/// places that neither shows have none. Where no edge of a lamp is mirrored, zebra is shown.
std::vector<CloseUp> close_ups(const Scene& scene, const LightRig& rig, const Report& report,
                               std::span<const NamedView> views, const PictureOptions& options,
                               std::size_t most, const Job& job);

} // namespace keiko
