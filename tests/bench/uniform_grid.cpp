#include "tests/bench/uniform_grid.h"

#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko::bench {

UniformGrid::UniformGrid(const SurfaceMesh& mesh) : mesh_(mesh) {
    for (const Vec3& position : mesh.positions) bounds_.extend(position);
    const Vec3 extent = bounds_.extent();
    const double edge =
        std::cbrt(extent.x * extent.y * extent.z / static_cast<double>(mesh.triangles.size()));
    for (unsigned i = 0; i < 3; ++i) {
        counts_[i] = std::max(1, static_cast<int>(extent[i] / edge));
        size_[i] = extent[i] / counts_[i];
    }
    in_cells_.resize(number_of({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        Box3 box;
        for (const std::uint32_t corner : mesh.triangles[t]) box.extend(mesh.positions[corner]);
        const Cell low = cell_at(box.lower), high = cell_at(box.upper);
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    in_cells_[number_of({x, y, z})].push_back(t);
    }
}

UniformGrid::Cell UniformGrid::cell_at(const Vec3& point) const {
    Cell cell{};
    for (unsigned i = 0; i < 3; ++i)
        cell[i] = std::clamp(static_cast<int>((point[i] - bounds_.lower[i]) / size_[i]), 0,
                             counts_[i] - 1);
    return cell;
}

std::optional<double> UniformGrid::first_in(const Cell& cell, const Ray& ray) const {
    std::optional<double> first;
    for (const std::uint32_t t : in_cells_[number_of(cell)]) {
        const auto& [a, b, c] = mesh_.triangles[t];
        const std::array corners{mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
        const Vec3 shares = ray_weights(corners, ray);
        if (!(std::min({shares.x, shares.y, shares.z}) >= 0)) continue;
        const double at = (mixed(shares, corners) - ray.origin).dot(ray.direction);
        if (at > 0 && (!first || at < *first)) first = at;
    }
    return first;
}

std::optional<double> UniformGrid::entry(const Ray& ray) const {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (unsigned i = 0; i < 3; ++i) {
        const double a = (bounds_.lower[i] - ray.origin[i]) / ray.direction[i],
                     b = (bounds_.upper[i] - ray.origin[i]) / ray.direction[i];
        enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? std::optional(enter) : std::nullopt;
}

UniformGrid::Side UniformGrid::exit(const Cell& cell, const Ray& ray) const {
    Side first{0, std::numeric_limits<double>::infinity()};
    for (unsigned i = 0; i < 3; ++i) {
        const int side = cell[i] + (ray.direction[i] > 0 ? 1 : 0);
        const double at = (bounds_.lower[i] + side * size_[i] - ray.origin[i]) / ray.direction[i];
        if (ray.direction[i] != 0 && at < first.t) first = {i, at};
    }
    return first;
}

std::optional<double> UniformGrid::first(const Ray& ray) const {
    const auto enter = entry(ray);
    if (!enter) return std::nullopt;
    Cell cell = cell_at(ray.at(*enter));
    while (true) {
        const Side side = exit(cell, ray);
        // A triangle may be met beyond the cell, where another is nearer.
        const auto met = first_in(cell, ray);
        if (met && *met <= side.t + 1e-9 * size_[side.axis]) return met;
        int& place = cell[side.axis];
        place += ray.direction[side.axis] > 0 ? 1 : -1;
        if (place < 0 || place >= counts_[side.axis]) return std::nullopt;
    }
}

} // namespace keiko::bench
