#pragma once

#include "keiko/inspect/openings/opening.h"

#include <span>

namespace keiko {

/// Bodies that are closed apart from one hole, as where a cap is missing: faces joined by seams
/// whose free edges form a single outline, up to `limits.from` mm of them left out. The outline is
/// flat: it lies within a tenth of its width of a plane. The hole is at most half as large as the
/// area of the body, so that panels are none, with flanges or without. Openings within the join
/// distance of the middles of `known` are left out, as are those up to `limits.gap` mm wide.
std::vector<Opening> missing_caps(const SurfaceModel& model, const BoundaryCurves& curves,
                                  const FreeEdges& edges, std::span<const Seam> seams,
                                  const OpeningLimits& limits, std::span<const Opening> known,
                                  const Job& job = {});

} // namespace keiko
