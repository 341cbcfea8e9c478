#pragma once

#include "keiko/base/job.h"
#include "keiko/scene/volume_spec.h"

#include <array>
#include <vector>

namespace keiko {

/// Values of a grid, x fastest, then y, after preprocessing. Beyond its borders the grid continues
/// with the nearest node. `spacing`: mm between nodes.
/// Throws FieldError for a Gaussian wider than 64 of them.
std::vector<float> filtered(const VoxelFilter& filter, std::vector<float> values,
                            const std::array<int, 3>& nodes, const Vec3& spacing, const Job& job);

} // namespace keiko
