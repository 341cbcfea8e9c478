#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/bounds.h"
#include "keiko/scene/volume_spec.h"
#include "keiko/volumes/clear_blocks.h"
#include "keiko/volumes/voxel_grid.h"

#include <optional>
#include <vector>

namespace keiko {

/// Part of a ray inside a volume, in its grid: steps between nodes from the first, which change by
/// mm of the ray.
struct GridRay {
    Vec3 origin{0}, direction{0};
    double begin = 0, end = 0; ///< mm along the ray

    /// Place in the grid.
    Vec3 at(double t) const { return origin + direction * t; }
};

/// A volume of a scene, classified: extinctions stand on the nodes and are trilinear between them
/// (docs/theory/volumes.md#classification).
class Volume {
public:
    /// Reads the voxels. Throws Error, and Cancelled.
    Volume(const VolumeSpec& spec, const Job& job);
    /// Volume of voxels in memory.
    Volume(const VolumeSpec& spec, VoxelGrid grid, const Job& job);

    /// Part of a segment inside the volume; none if it misses it.
    std::optional<GridRay> crossing(const Segment& segment) const;
    /// mm between samples.
    double step() const { return step_; }
    /// Box of the volume in the scene, mm.
    Box3 bounds() const;
    /// The ray is clear from t on until what is returned, mm; t itself where it may not be.
    double clear_until(const GridRay& ray, double t) const;
    /// Extinction at a place of the grid, 1/mm.
    double extinction(const Vec3& place) const { return grid_.value_of(extinctions_, place); }
    /// Specification that it was made of.
    const VolumeSpec& spec() const { return spec_; }
    /// Number of nodes along x, y and z.
    const std::array<int, 3>& nodes() const { return grid_.nodes(); }
    /// Place in the scene, mm, of one in the grid.
    Vec3 scene_place(const Vec3& in_grid) const { return from_grid_.point(in_grid); }
    /// Vector in the grid of one in the scene.
    Vec3 grid_vector(const Vec3& in_scene) const { return to_grid_.vector(in_scene); }
    /// Mean extinction of the nodes, 1/mm.
    double mean_extinction() const;
    /// cd/m2 of an opaque layer at a place of the grid, `distance` mm from the viewer, without the
    /// light of sun and sky.
    Rgb luminance(const Vec3& place, const Vec3& to_viewer, double distance) const;

private:
    /// Extinctions of all nodes, 1/mm.
    std::vector<float> classified(const Job& job) const;
    /// Gradient in the scene, per mm, of one in the grid, per step.
    Vec3 scene_gradient(const Vec3& in_grid) const;

    VolumeSpec spec_;
    VoxelGrid grid_;
    Affine to_grid_, from_grid_;     ///< of places in the scene, and back
    double smallest_ = 1;            ///< mm in the scene, the smallest step between nodes
    double step_ = 1;                ///< mm between samples
    std::vector<float> extinctions_; ///< 1/mm, of the nodes
    ClearBlocks clear_;
};

} // namespace keiko
