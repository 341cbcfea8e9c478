#pragma once

#include "keiko/drawing/line_body.h"
#include "keiko/drawing/sheet/sheet_layout.h"
#include "keiko/math/bounds.h"
#include "keiko/scene/camera.h"

#include <string>
#include <vector>

namespace keiko {

/// Names of the views of a sheet in first-angle projection, in the order of
/// SheetOptions::three_views.
const std::vector<std::string>& three_views();

/// Sets both dimensions of a view to the extent of a body's box along the axes of its picture, if
/// they are axes of space.
void add_dimensions(SheetView& view, const Camera& camera, const Box3& box);

/// Marks at places in a view, numbered from 1. `wireframe`: all as visible.
std::vector<SheetMark> marks_at(const std::vector<Vec3>& places, const LineBody& body,
                                const Camera& camera, bool wireframe);

} // namespace keiko
