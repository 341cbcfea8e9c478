#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/curve_set.h"
#include "keiko/inspect/lines/contour_curves.h"

#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The contour curves of a view as B-splines for other programs, like those of line_curves. Each
/// has its view, its face and its deviation in its name.
std::vector<NamedCurve> contour_set(const SurfaceModel& model, const std::string& view,
                                    std::span<const ContourLine> contours);

} // namespace keiko
