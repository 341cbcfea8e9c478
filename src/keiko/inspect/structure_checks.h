#pragma once

#include "keiko/inspect/check.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// The criteria of the preset's StructureLimits held against each measured face: spans, patches and
/// edges. Empty if it has none. Throws Cancelled.
std::vector<Check> structure_checks(const ModelBorders& borders,
                                    std::span<const MeasuredFace> faces,
                                    const StructureLimits& limits, const Job& job = {});

} // namespace keiko
