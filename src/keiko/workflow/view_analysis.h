#pragma once

#include "keiko/base/export.h"
#include "keiko/files/scene/view_request.h"
#include "keiko/workflow/open_scene.h"

#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// The analysis that a request states, under the rows of lamps that it has in place of those of
/// `rig`. Hidden faces get their names and places on the body, notes the faces that they lie on.
/// Throws Error for an analysis that no file may hold, and Cancelled.
Analysis requested_analysis(const ViewRequest& request, const LightRig& rig,
                            const SurfaceModel& body, const Job& job = {});

/// "keiko-view-analysis/1" of docs/file-formats.md: an analysis on the body that is viewed, or
/// null; remarks on what could not be followed; and the rig that is shown.
std::string view_analysis_json(const std::optional<FollowedAnalysis>& shown, const LightRig& rig);

} // namespace keiko
