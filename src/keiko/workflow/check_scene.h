#pragma once

#include "keiko/base/export.h"
#include "keiko/workflow/check_models.h"
#include "keiko/workflow/open_scene.h"

namespace KEIKO_API keiko {

/// Judges the geometry of a scene that has been opened, as check_models does. Of the options, those
/// of reading, combs and profiles are not read. Throws Error for zones without a face, and
/// Cancelled.
Inspection check_scene(const Scene& scene, const CheckOptions& options = {}, const Job& job = {});

} // namespace keiko
