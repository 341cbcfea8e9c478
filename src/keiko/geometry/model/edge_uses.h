#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <vector>

namespace keiko {

/// Trim curves that follow each other along one side of an edge.
struct EdgeUse {
    std::uint32_t face = 0, first_curve = 0, curve_count = 0;
};

/// The uses of each edge of a model, in file order.
std::vector<std::vector<EdgeUse>> edge_uses(const SurfaceModel& model);

} // namespace keiko
