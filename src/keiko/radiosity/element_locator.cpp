#include "keiko/radiosity/element_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace keiko {
namespace {

std::size_t cell_along(double at, double begin, double end, std::size_t cells) {
    const double place = (at - begin) / (end - begin) * static_cast<double>(cells);
    if (!(place > 0)) return 0;
    return static_cast<std::size_t>(std::min(place, static_cast<double>(cells - 1)));
}

/// Fills empty cells of a square grid, `n` a side, with what one of the nearest filled ones holds.
void fill_empty(std::vector<std::vector<std::uint32_t>>& cells, std::size_t n) {
    std::vector<std::size_t> filled;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (!cells[i].empty()) filled.push_back(i);
    const auto fill = [&](std::size_t from, std::size_t to) {
        if (!cells[to].empty()) return;
        cells[to] = cells[from];
        filled.push_back(to);
    };
    for (std::size_t next = 0; next < filled.size(); ++next) { // which grows meanwhile
        const std::size_t i = filled[next], x = i % n, y = i / n;
        if (x > 0) fill(i, i - 1);
        if (x + 1 < n) fill(i, i + 1);
        if (y > 0) fill(i, i - n);
        if (y + 1 < n) fill(i, i + n);
    }
}

} // namespace

ElementLocator::ElementLocator(const SurfaceModel& model, std::span<const Vec2> uv,
                               std::span<const SolvedTriangle> triangles)
    : model_(model), uv_(uv), triangles_(triangles) {
    std::map<std::uint64_t, std::vector<std::uint32_t>> by_face;
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        by_face[key(triangles[t].instance, triangles[t].face)].push_back(t);
    for (const auto& [placed, all] : by_face) grids_.emplace(placed, grid_of(all));
}

std::uint64_t ElementLocator::key(std::uint32_t instance, std::uint32_t face) const {
    return (std::uint64_t{instance} << 32U) | face;
}

ElementLocator::Grid ElementLocator::grid_of(std::span<const std::uint32_t> triangles) const {
    constexpr std::size_t most_cells = 128;
    Grid grid;
    const double wanted = std::sqrt(2.0 * static_cast<double>(triangles.size()));
    grid.cells = std::min(most_cells, static_cast<std::size_t>(std::ceil(wanted)));
    for (const std::uint32_t t : triangles)
        for (const std::uint32_t corner : triangles_[t].corners) grid.box.extend(uv_[corner]);
    std::vector<std::vector<std::uint32_t>> cells(grid.cells * grid.cells);
    for (const std::uint32_t t : triangles) {
        Box2 box;
        for (const std::uint32_t corner : triangles_[t].corners) box.extend(uv_[corner]);
        const auto cell = [&](double at, bool u) {
            return u ? cell_along(at, grid.box.lower.x, grid.box.upper.x, grid.cells)
                     : cell_along(at, grid.box.lower.y, grid.box.upper.y, grid.cells);
        };
        for (std::size_t y = cell(box.lower.y, false); y <= cell(box.upper.y, false); ++y)
            for (std::size_t x = cell(box.lower.x, true); x <= cell(box.upper.x, true); ++x)
                cells[y * grid.cells + x].push_back(t);
    }
    fill_empty(cells, grid.cells);
    grid.first.push_back(0);
    for (const auto& cell : cells) {
        grid.found.insert(grid.found.end(), cell.begin(), cell.end());
        grid.first.push_back(grid.found.size());
    }
    return grid;
}

/// Barycentric coordinates of face parameters; below 0 outside.
Vec3 ElementLocator::shares_at(std::uint32_t triangle, const Vec2& uv) const {
    const auto& [i, j, k] = triangles_[triangle].corners;
    const Vec2 a = uv_[i] - uv, b = uv_[j] - uv, c = uv_[k] - uv;
    const Vec3 doubled(b.cross(c), c.cross(a), a.cross(b));
    return doubled / (doubled.x + doubled.y + doubled.z);
}

std::optional<TrianglePlace> ElementLocator::at(std::uint32_t instance, std::uint32_t patch,
                                                const Vec2& uv) const {
    const Patch& of = model_.patches[patch];
    const auto found = grids_.find(key(instance, of.face));
    if (found == grids_.end()) return std::nullopt;
    const Grid& grid = found->second;
    const Vec2 place(of.map_u.to_face(uv.x), of.map_v.to_face(uv.y));
    const std::size_t cell =
        cell_along(place.y, grid.box.lower.y, grid.box.upper.y, grid.cells) * grid.cells +
        cell_along(place.x, grid.box.lower.x, grid.box.upper.x, grid.cells);
    std::optional<TrianglePlace> best;
    double least = -std::numeric_limits<double>::infinity();
    for (std::size_t i = grid.first[cell]; i < grid.first[cell + 1] && least < 0; ++i) {
        const Vec3 shares = shares_at(grid.found[i], place);
        const double inside = std::min({shares.x, shares.y, shares.z});
        if (inside > least) least = inside, best = TrianglePlace{grid.found[i], shares};
    }
    if (!best) return best;
    Vec3& s = best->shares;
    s = Vec3(std::max(s.x, 0.0), std::max(s.y, 0.0), std::max(s.z, 0.0));
    s /= s.x + s.y + s.z;
    return best;
}

bool ElementLocator::front_is_normal(std::uint32_t instance, std::uint32_t patch) const {
    return model_.faces[model_.patches[patch].face].reversed ==
           model_.instances[instance].transform.mirrored();
}

} // namespace keiko
