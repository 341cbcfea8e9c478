#pragma once

#include "keiko/inspect/check.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// The criteria of a face's StructureLimits that faces, edges and loops must not meet each other or
/// themselves, of measured faces in the scope. A check is there only where one is not met. Throws
/// Cancelled.
std::vector<Check> contact_checks(const ModelBorders& borders, std::span<const MeasuredFace> faces,
                                  const FaceLimits& limits, const Job& job = {});

} // namespace keiko
