#include "keiko/volumes/volume.h"

#include "keiko/base/parallel.h"
#include "keiko/volumes/opacity.h"
#include "keiko/volumes/read_voxels.h"
#include "keiko/volumes/volume_shading.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

Vec3 reciprocal(const Vec3& v) {
    return {1 / v.x, 1 / v.y, 1 / v.z};
}

/// Map from the scene to steps between nodes.
Affine grid_map(const VolumeSpec& spec) {
    const Vec3 per = reciprocal(spec.voxels.spacing);
    const Affine steps{.rows = {Vec3(per.x, 0, 0), Vec3(0, per.y, 0), Vec3(0, 0, per.z)},
                       .translation = -spec.voxels.origin * per};
    return steps * spec.placement.inverse();
}

} // namespace

Volume::Volume(const VolumeSpec& spec, const Job& job)
    : Volume(spec, read_voxels(spec.voxels, spec.filters, job), job) {}

Volume::Volume(const VolumeSpec& spec, VoxelGrid grid, const Job& job)
    : spec_(spec),
      grid_(std::move(grid)),
      to_grid_(grid_map(spec)),
      from_grid_(to_grid_.inverse()),
      smallest_(std::cbrt(std::abs(spec.placement.determinant())) *
                std::min({spec.voxels.spacing.x, spec.voxels.spacing.y, spec.voxels.spacing.z})),
      step_(spec.step > 0 ? spec.step : smallest_ / 2),
      extinctions_(classified(job)),
      clear_(grid_.nodes(), extinctions_) {}

std::vector<float> Volume::classified(const Job& job) const {
    const auto [wide, deep, high] = grid_.nodes();
    const auto columns = static_cast<std::size_t>(wide), rows = static_cast<std::size_t>(deep);
    std::vector<float> extinctions(grid_.values().size());
    parallel_for(static_cast<std::size_t>(high), job, "", [&](std::size_t z) {
        for (std::size_t y = 0; y < rows; ++y)
            for (std::size_t x = 0; x < columns; ++x) {
                const std::size_t node = grid_.index(x, y, z);
                const Vec3 gradient = scene_gradient(grid_.node_gradient(x, y, z));
                const double depth = node_depth(spec_, smallest_, grid_.values()[node],
                                                gradient.length() * smallest_);
                extinctions[node] = static_cast<float>(depth / smallest_);
            }
    });
    return extinctions;
}

Vec3 Volume::scene_gradient(const Vec3& in_grid) const {
    const auto& rows = to_grid_.rows; // its transpose takes gradients to the scene
    return rows[0] * in_grid.x + rows[1] * in_grid.y + rows[2] * in_grid.z;
}

std::optional<GridRay> Volume::crossing(const Segment& segment) const {
    const Vec3 way = segment.b - segment.a;
    const double length = way.length();
    GridRay ray{to_grid_.point(segment.a), to_grid_.vector(way / length), 0, length};
    for (unsigned axis = 0; axis < 3; ++axis) {
        const double last = grid_.nodes()[axis] - 1;
        const double a = -ray.origin[axis] / ray.direction[axis];
        const double b = (last - ray.origin[axis]) / ray.direction[axis];
        if (ray.direction[axis] == 0) {
            if (!(ray.origin[axis] >= 0 && ray.origin[axis] <= last)) return {};
            continue;
        }
        ray.begin = std::max(ray.begin, std::min(a, b));
        ray.end = std::min(ray.end, std::max(a, b));
    }
    if (!(ray.begin < ray.end)) return {};
    return ray;
}

Box3 Volume::bounds() const {
    const auto& nodes = grid_.nodes();
    return transformed(from_grid_, Box3{Vec3(0), Vec3(nodes[0] - 1, nodes[1] - 1, nodes[2] - 1)});
}

double Volume::mean_extinction() const {
    double sum = 0;
    for (const float extinction : extinctions_) sum += static_cast<double>(extinction);
    return sum / static_cast<double>(extinctions_.size());
}

double Volume::clear_until(const GridRay& ray, double t) const {
    return clear_.leaves(ray.origin, ray.direction, t);
}

Rgb Volume::luminance(const Vec3& place, const Vec3& to_viewer, double distance) const {
    const double value = grid_.value(place);
    Rgb sum = spec_.emits(value);
    if (!spec_.shading) return sum;
    const Vec3 normal = volume_normal(scene_gradient(grid_.gradient(place)) * smallest_);
    const Vec3 to_light = spec_.shading->light ? spec_.shading->light->normalized() : to_viewer;
    const ShadingTerms terms = shading_terms(*spec_.shading, normal, to_light, to_viewer);
    const Rgb color = grid_.colored() ? grid_.color(place) : spec_.color(value);
    return sum + shaded_luminance(*spec_.shading, terms, color, distance);
}

} // namespace keiko
