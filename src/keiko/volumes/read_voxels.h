#pragma once

#include "keiko/base/job.h"
#include "keiko/scene/volume_spec.h"
#include "keiko/volumes/voxel_grid.h"

#include <span>

namespace keiko {

/// Reads voxels and applies the filters to their values. The value of a coloured voxel is the
/// luminance of its colour. Throws Error naming the file for slices of several sizes, for files of
/// another length than their header states, and for values that are not finite.
VoxelGrid read_voxels(const VoxelFiles& files, std::span<const VoxelFilter> filters,
                      const Job& job);

} // namespace keiko
