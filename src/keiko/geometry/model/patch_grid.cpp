#include "keiko/geometry/model/patch_grid.h"

#include <algorithm>

namespace keiko {
namespace {

/// Knots nearer than this share of the domain are one knot: a p-curve along a knot line is only
/// as straight as the file's digits.
constexpr double relative_knot_tolerance = 1e-9;

std::vector<double> distinct(std::vector<double> breaks) {
    std::sort(breaks.begin(), breaks.end());
    const double same = (breaks.back() - breaks.front()) * relative_knot_tolerance;
    const auto last = std::unique(breaks.begin(), breaks.end(),
                                  [&](double a, double b) { return b - a <= same; });
    breaks.erase(last, breaks.end());
    if (breaks.size() < 2) breaks.push_back(breaks.front());
    return breaks;
}

double same_knot(const std::vector<double>& breaks) {
    return (breaks.back() - breaks.front()) * relative_knot_tolerance;
}

std::size_t cell_of(const std::vector<double>& breaks, double x, double toward) {
    const double near = same_knot(breaks);
    const double probe = x + (toward < 0 ? -near : near);
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, probe);
    return static_cast<std::size_t>(above - breaks.begin()) - 1;
}

/// The cells that a patch covers: several where its neighbours were split further.
struct CellRange {
    std::size_t first, last;

    CellRange(const std::vector<double>& breaks, const ParameterMap& map)
        : first(cell_of(breaks, map.begin, 1)), last(cell_of(breaks, map.end, -1)) {}
};

/// A patch between two knots that are one knot covers no cell of the grid.
bool is_sliver(const ParameterMap& map, const std::vector<double>& breaks) {
    return map.end - map.begin <= same_knot(breaks);
}

} // namespace

PatchGrid::PatchGrid(const SurfaceModel& model, const Face& face) : first_patch_(face.first_patch) {
    std::vector<double> u, v;
    for (const Patch& p : model.patches_of(face)) {
        u.insert(u.end(), {p.map_u.begin, p.map_u.end});
        v.insert(v.end(), {p.map_v.begin, p.map_v.end});
    }
    if (u.empty()) return;
    breaks_u_ = distinct(std::move(u));
    breaks_v_ = distinct(std::move(v));
    const std::size_t rows = breaks_v_.size() - 1;
    patches_.assign((breaks_u_.size() - 1) * rows, face.first_patch);
    for (std::uint32_t k = 0; k < face.patch_count; ++k) {
        const Patch& p = model.patches[face.first_patch + k];
        const double size = hull_bounds(model.patch(face.first_patch + k)).size();
        square_sizes_.push_back(size * size);
        if (is_sliver(p.map_u, breaks_u_) || is_sliver(p.map_v, breaks_v_)) continue;
        const CellRange us(breaks_u_, p.map_u), vs(breaks_v_, p.map_v);
        for (std::size_t i = us.first; i <= us.last; ++i)
            for (std::size_t j = vs.first; j <= vs.last; ++j)
                patches_[i * rows + j] = face.first_patch + k;
    }
}

std::uint32_t PatchGrid::locate(const Vec2& point, const Vec2& toward) const {
    const std::size_t i = cell_of(breaks_u_, point.x, toward.x);
    const std::size_t j = cell_of(breaks_v_, point.y, toward.y);
    return patches_[i * (breaks_v_.size() - 1) + j];
}

Box2 PatchGrid::domain() const {
    Box2 box;
    if (patches_.empty()) return box;
    box.extend(Vec2(breaks_u_.front(), breaks_v_.front()));
    box.extend(Vec2(breaks_u_.back(), breaks_v_.back()));
    return box;
}

int PatchGrid::lines_through(const Box2& box) const {
    const auto inside = [](const std::vector<double>& breaks, double low, double high) {
        return std::count_if(breaks.begin(), breaks.end(),
                             [&](double x) { return low < x && x < high; });
    };
    return static_cast<int>(inside(breaks_u_, box.lower.x, box.upper.x) +
                            inside(breaks_v_, box.lower.y, box.upper.y));
}

PatchPlace place_at(const SurfaceModel& model, const PatchGrid& grid, const Vec2& parameters) {
    const Box2 domain = grid.domain();
    const Vec2 within = domain.nearest(parameters);
    const std::uint32_t index = grid.locate(within, domain.center() - within);
    const Patch& patch = model.patches[index];
    return {index,
            {std::clamp(patch.map_u.to_patch(within.x), 0.0, 1.0),
             std::clamp(patch.map_v.to_patch(within.y), 0.0, 1.0)}};
}

} // namespace keiko
