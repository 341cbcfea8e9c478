#include "keiko/compare/scan/point_order.h"

#include "keiko/math/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// Bits of each coordinate in a key.
constexpr unsigned bits = 21;

Box3 box_of(std::span<const Vec3> points) {
    Box3 box;
    for (const Vec3& point : points) box.extend(point);
    return box;
}

/// The lower bits of a number with two zeros between each two of them.
std::uint64_t spread(std::uint64_t x) {
    x &= (std::uint64_t{1} << bits) - 1;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

using KeyedPoint = std::pair<std::uint64_t, std::uint32_t>;

template <class Key>
std::vector<KeyedPoint> sorted_by(std::span<const Vec3> points, const Key& key) {
    std::vector<KeyedPoint> keyed;
    keyed.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) keyed.emplace_back(key(points[i]), i);
    std::sort(keyed.begin(), keyed.end());
    return keyed;
}

} // namespace

std::vector<std::uint32_t> neighbour_order(std::span<const Vec3> points) {
    const Box3 box = box_of(points);
    const double most = static_cast<double>((1u << bits) - 1);
    const Vec3 extent = box.extent();
    const double longest = std::max({extent.x, extent.y, extent.z});
    const double scale = longest > 0 ? most / longest : 0;
    std::vector<std::uint32_t> order;
    order.reserve(points.size());
    for (const auto& [key, index] : sorted_by(points, [&](const Vec3& point) {
             const Vec3 at = (point - box.lower) * scale;
             return spread(static_cast<std::uint64_t>(at.x)) |
                    spread(static_cast<std::uint64_t>(at.y)) << 1 |
                    spread(static_cast<std::uint64_t>(at.z)) << 2;
         }))
        order.push_back(index);
    return order;
}

double point_spacing(std::span<const Vec3> points) {
    // With many points to a cell, none that the surface passes is empty.
    constexpr double points_a_cell = 16;
    const double size = box_of(points).size();
    if (!(size > 0)) return 0;
    const auto count = static_cast<double>(points.size());
    const double cell = size / std::sqrt(count / points_a_cell + 1);
    const auto filled = static_cast<double>(PointGrid(points, cell).cell_count());
    return cell * std::sqrt(filled / count);
}

PointGrid::PointGrid(std::span<const Vec3> points, double radius)
    : points_(points), lower_(box_of(points).lower), radius_(radius) {
    order_.reserve(points.size());
    for (const auto& [key, index] :
         sorted_by(points, [&](const Vec3& point) { return key_of(point, 0, 0, 0); })) {
        if (cells_.empty() || cells_.back().key != key)
            cells_.push_back({key, static_cast<std::uint32_t>(order_.size()), 0});
        order_.push_back(index);
        cells_.back().end = static_cast<std::uint32_t>(order_.size());
    }
}

std::uint64_t PointGrid::key_of(const Vec3& place, int dx, int dy, int dz) const {
    std::uint64_t key = 0;
    const std::array<int, 3> by{dx, dy, dz};
    for (unsigned k = 0; k < 3; ++k) {
        // One more than the cell, so that the neighbour below the first has a key, too.
        const double cell = std::floor((place[k] - lower_[k]) / radius_) + 1 + by[k];
        constexpr double most = (1u << bits) - 1;
        key = key << bits | static_cast<std::uint64_t>(std::clamp(cell, 0.0, most));
    }
    return key;
}

std::vector<std::uint32_t> PointGrid::near_points(const Vec3& place) const {
    std::vector<std::uint32_t> found;
    for (int n = 0; n < 27; ++n) {
        const std::uint64_t key = key_of(place, n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1);
        const auto cell =
            std::lower_bound(cells_.begin(), cells_.end(), key,
                             [](const Cell& c, std::uint64_t wanted) { return c.key < wanted; });
        if (cell == cells_.end() || cell->key != key) continue;
        for (std::uint32_t k = cell->first; k < cell->end; ++k)
            if ((points_[order_[k]] - place).length() <= radius_) found.push_back(order_[k]);
    }
    return found;
}

} // namespace keiko
