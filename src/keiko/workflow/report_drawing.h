#pragma once

#include "keiko/inspect/check.h"
#include "keiko/workflow/open_scene.h"

#include <span>
#include <string>

namespace keiko {

/// Why the page of a report has no line drawing of a body: a sentence, where it has too many faces
/// to be drawn beside its report; else empty.
std::string drawing_remark(const SurfaceModel& model);

/// The line drawing of a scene's body for the page of a report, as SVG: left, front and top view by
/// parallel rays, hidden lines dashed, findings numbered from 1. `join`: mm, within which two
/// borders are a seam. The drawing_remark() instead, if there is one; empty for a body
/// without lines. Throws Cancelled.
std::string report_drawing(const Scene& scene, std::span<const Check> findings, double join,
                           const Job& job = {});

} // namespace keiko
