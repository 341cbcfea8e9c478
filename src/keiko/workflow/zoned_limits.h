#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/workflow/face_sets.h"
#include "keiko/workflow/open_scene.h"

namespace keiko {

/// Limits of a preset by the zones that its faces belong to, each to the first that selects it, and
/// the part of the body that is judged. Throws Error naming file and zone for a zone that is left
/// without a face. Throws FieldError for a scope without a face, for a word of it that selects none
/// and for a zone that the preset does not have. Throws Cancelled.
FaceLimits zoned_limits(const ZonedBody& body, const CriteriaPreset& preset, const Scope& scope,
                        const Job& job);

/// zoned_limits() of the body of a scene.
FaceLimits limits_in(const Scene& scene, const CriteriaPreset& preset, const Scope& scope,
                     const Job& job);

} // namespace keiko
