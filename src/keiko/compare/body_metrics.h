#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/inspect/lines/surface_lines.h"
#include "keiko/scene/fixture_spec.h"

#include <span>
#include <vector>

namespace keiko {

/// Metrics of the check "shape": the numbers of faces, patches and seams. For every placed face
/// they hold the area, centre and mean outward direction of its surfaces without their trims, and
/// the length and centre of its borders. They are quadratures of fixed order: exact to about 1e-9,
/// and the same for the same shape.
std::vector<Metric> shape_metrics(const SurfaceModel& model, const ModelFacts& facts);

/// "seams": length, gap, angle, curvature mismatch, its slope, and the verdicts of every seam.
std::vector<Metric> seam_metrics(const Inspection& inspection);

/// "lines": of every lamp of the `sources` the length of its lines that `view` shows.
std::vector<Metric> line_metrics(const std::string& view, std::span<const LineSource> sources,
                                 std::span<const SurfaceLine> lines);

} // namespace keiko
