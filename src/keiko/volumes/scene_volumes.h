#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/bounds.h"
#include "keiko/scene/volume_spec.h"
#include "keiko/volumes/volume.h"

#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// All volumes of a scene.
class SceneVolumes {
public:
    /// Reads the voxels. Throws Error, and Cancelled.
    explicit SceneVolumes(std::span<const VolumeSpec> specs, const Job& job = {});
    /// Volumes that have been read.
    explicit SceneVolumes(std::vector<Volume> volumes) : volumes_(std::move(volumes)) {}

    /// The volumes, in the order of the scene.
    const std::vector<Volume>& volumes() const { return volumes_; }
    /// Boxes of the volumes, mm.
    std::vector<Box3> boxes() const;
    /// Distance from a place beyond which there is no volume, mm; 0 without any.
    double reach_from(const Vec3& place) const;
    /// Optical depth of all volumes along a segment, or more than `most` where it is more.
    double optical_depth(const Segment& segment, double most) const;

private:
    std::vector<Volume> volumes_;
};

} // namespace keiko
