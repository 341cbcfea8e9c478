#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/placement/best_view.h"
#include "keiko/placement/placement.h"

#include <span>
#include <string>

namespace keiko {

/// A placement or the rating of a rig as "keiko-placement/1". Whole: tool {name, version}, rig,
/// views, coverage, blocked, stripes {narrow, median, wide, in_range, uniformity}. Lamps: planes
/// [{origin, u, v, lamps, pitch, diameter, score}]. Body: faces [{id, name, instance, share,
/// reached}], unreached [{view, because, share, place, box {lower, upper}, faces [ids], pixels [x0,
/// y0, x1, y1]}]. Further positions: candidates [{towards, distance, score}]. A score is {coverage,
/// stripes, uniformity, in_range, crossing, compactness, objective}. Lengths are in mm, spacings in
/// pixels, shares of 1.
std::string placement_json(const Placement& placement, const SurfaceModel& model,
                           std::span<const std::string> views, const std::string& tool_version);

/// The format keiko-hits/1 of docs/file-formats.md.
std::string hits_json(const RegisteredHits& hits, const std::string& tool_version);

/// Inverse of hits_json, bit for bit. `file` is for messages. Throws Error for any other text.
RegisteredHits hits_from_json(const std::string& text, const std::string& file);

} // namespace keiko
