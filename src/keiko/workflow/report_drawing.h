#pragma once

#include "keiko/inspect/check.h"
#include "keiko/workflow/open_scene.h"

#include <span>
#include <string>

namespace keiko {

/// The line drawing of a scene's body for the page of a report, as SVG: left, front and top view by
/// parallel rays, hidden lines dashed, findings numbered from 1. `join`: mm, within which two
/// borders are a seam. Empty for a body that is too large for a drawing beside its report, or
/// without lines. Throws Cancelled.
std::string report_drawing(const Scene& scene, std::span<const Check> findings, double join,
                           const Job& job = {});

} // namespace keiko
