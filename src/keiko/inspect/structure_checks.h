#pragma once

#include "keiko/inspect/check.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// The criteria of a face's StructureLimits held against each measured face in the scope: spans,
/// patches and edges. Empty if none has any. Throws Cancelled.
std::vector<Check> structure_checks(const ModelBorders& borders,
                                    std::span<const MeasuredFace> faces, const FaceLimits& limits,
                                    const Job& job = {});

} // namespace keiko
