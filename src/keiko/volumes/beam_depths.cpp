#include "keiko/volumes/beam_depths.h"

#include "keiko/base/parallel.h"
#include "keiko/math/trilinear.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace keiko {

BeamDepths::BeamDepths(const SceneVolumes& scene, const Volume& volume, const Vec3& towards,
                       double most, const StopOfLight& stops, const Job& job) {
    const Vec3 way = volume.grid_vector(towards);
    for (unsigned axis = 0; axis < 3; ++axis)
        if (std::abs(way[axis]) > std::abs(way[axes_[2]])) axes_[2] = axis;
    axes_[0] = (axes_[2] + 1) % 3, axes_[1] = (axes_[2] + 2) % 3;
    from_last_ = way[axes_[2]] > 0;
    slant_u_ = way[axes_[0]] / way[axes_[2]], slant_v_ = way[axes_[1]] / way[axes_[2]];
    const auto cells = [&](unsigned i) { return volume.nodes()[axes_[i]] - 1.0; };
    const double step = std::max(1.0, std::cbrt(cells(0) * cells(1) * cells(2) / most));
    const double along = cells(2);
    first_u_ = -std::max(0.0, slant_u_ * along), first_v_ = -std::max(0.0, slant_v_ * along);
    const std::array<double, 3> extents{cells(0) + std::abs(slant_u_) * along,
                                        cells(1) + std::abs(slant_v_) * along, along};
    for (unsigned i = 0; i < 3; ++i) {
        nodes_[i] = static_cast<int>(std::ceil(extents[i] / step - 1e-9)) + 1;
        steps_[i] = extents[i] / (nodes_[i] - 1);
    }
    const auto rows = static_cast<std::size_t>(nodes_[1]);
    const auto layers = static_cast<std::size_t>(nodes_[2]);
    depths_.resize(static_cast<std::size_t>(nodes_[0]) * rows * layers);
    parallel_for(static_cast<std::size_t>(nodes_[0]), job, "", [&](std::size_t i) {
        for (std::size_t j = 0; j < rows; ++j) {
            const std::vector<double> line =
                along_line(scene, volume, static_cast<int>(i), static_cast<int>(j), towards, stops);
            for (std::size_t k = 0; k < layers; ++k)
                depths_[(i * rows + j) * layers + (from_last_ ? layers - 1 - k : k)] =
                    static_cast<float>(line[k]);
        }
    });
}

Vec3 BeamDepths::node(int i, int j, int layer) const {
    const double along = layer * steps_.z;
    Vec3 place(0);
    place[axes_[0]] = first_u_ + i * steps_.x + slant_u_ * along;
    place[axes_[1]] = first_v_ + j * steps_.y + slant_v_ * along;
    place[axes_[2]] = along;
    return place;
}

std::vector<double> BeamDepths::along_line(const SceneVolumes& scene, const Volume& volume, int i,
                                           int j, const Vec3& towards,
                                           const StopOfLight& stops) const {
    const auto place = [&](int k) {
        return volume.scene_place(node(i, j, from_last_ ? nodes_[2] - 1 - k : k));
    };
    const Vec3 first = place(0);
    std::vector<double> depths(static_cast<std::size_t>(nodes_[2]), darkness);
    if (stops && std::isfinite(stops(first, towards))) return depths;
    const double stop = stops ? stops(first, -towards) : std::numeric_limits<double>::infinity();
    Vec3 before = first + towards * scene.reach_from(first);
    double depth = 0;
    for (int k = 0; k < nodes_[2]; ++k) {
        const Vec3 here = place(k);
        if ((here - first).length() > stop) break;
        depth += scene.optical_depth({before, here}, darkness - depth);
        if (depth >= darkness) break;
        depths[static_cast<std::size_t>(k)] = depth;
        before = here;
    }
    return depths;
}

BeamDepths BeamDepths::uniform(const Volume& volume, const Vec3& towards, double extinction) {
    BeamDepths depths;
    const auto& [columns, rows, layers] = volume.nodes();
    depths.uniform_ = {extinction, Vec3(columns - 1, rows - 1, layers - 1),
                       volume.grid_vector(towards)};
    return depths;
}

double BeamDepths::in_uniform(const Vec3& place) const {
    double length = std::numeric_limits<double>::infinity();
    for (unsigned axis = 0; axis < 3; ++axis) {
        const double way = uniform_.way[axis];
        if (way != 0)
            length = std::min(length, ((way > 0 ? uniform_.last[axis] : 0) - place[axis]) / way);
    }
    return uniform_.extinction * std::max(0.0, length);
}

double BeamDepths::operator()(const Vec3& place) const {
    if (depths_.empty()) return in_uniform(place);
    const double along = place[axes_[2]];
    const Vec3 at((place[axes_[0]] - slant_u_ * along - first_u_) / steps_.x,
                  (place[axes_[1]] - slant_v_ * along - first_v_) / steps_.y, along / steps_.z);
    const GridCell cell = grid_cell(at, nodes_);
    const auto rows = static_cast<std::size_t>(nodes_[1]);
    const auto layers = static_cast<std::size_t>(nodes_[2]);
    const float* first = &depths_[(cell.node[0] * rows + cell.node[1]) * layers + cell.node[2]];
    return trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
        return static_cast<double>(first[(x * rows + y) * layers + z]);
    });
}

} // namespace keiko
