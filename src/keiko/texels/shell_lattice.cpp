#include "keiko/texels/shell_lattice.h"

#include "keiko/geometry/model/outward_side.h"
#include "keiko/geometry/model/patch_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// A placed face that is sampled.
struct SampledFace {
    const SurfaceModel& model;
    const PatchGrid& grid;
    std::uint32_t instance;

    /// Unit outward normal near a place; at a pole that of a place beside it.
    Vec3 normal(const Box2& domain, Vec2 parameters) const {
        for (const double inwards : {0.0, 1e-6, 1e-3}) {
            const Vec2 at = parameters + (domain.center() - parameters) * inwards;
            const PatchPlace place = place_at(model, grid, at);
            const SurfaceDerivatives s = evaluate(model.patch(place.patch), place.uv, 1);
            const Affine& transform = model.instances[instance].transform;
            const Vec3 across = transform.vector(s.du()).cross(transform.vector(s.dv()));
            constexpr double pole = 1e-9; // of the size: rounding alone makes a direction there
            if (across.length() > pole * grid.square_size(place.patch))
                return across.normalized() * outward_side(model, instance, place.patch, place.uv);
        }
        return Vec3(0);
    }
    Vec3 point(const Vec2& parameters) const {
        const PatchPlace place = place_at(model, grid, parameters);
        const SurfaceDerivatives s = evaluate(model.patch(place.patch), place.uv, 0);
        return model.instances[instance].transform.point(s.position());
    }
};

void sample(const SampledFace& face, double thickness, ShellLattice& lattice) {
    lattice.foot.clear(), lattice.top.clear();
    for (int i = 0; i <= lattice.cells_u; ++i)
        for (int j = 0; j <= lattice.cells_v; ++j) {
            const Vec2 parameters = lattice.parameters(i, j);
            lattice.foot.push_back(face.point(parameters));
            lattice.top.push_back(lattice.foot.back() +
                                  face.normal(lattice.domain, parameters) * thickness);
        }
}

/// Calls `visit` for each pair of neighbouring edges along u (0) or v (1) with their three nodes.
template <class Visit>
void each_bend(const ShellLattice& lattice, int axis, const Visit& visit) {
    const int du = axis == 0 ? 1 : 0, dv = 1 - du;
    for (int i = du; i <= lattice.cells_u - du; ++i)
        for (int j = dv; j <= lattice.cells_v - dv; ++j)
            visit(lattice.index(i - du, j - dv), lattice.index(i, j),
                  lattice.index(i + du, j + dv));
}

/// mm by which the middle of a cell may be off its surface, since it is divided along a diagonal.
double twist_of(const ShellLattice& lattice) {
    double twist = 0;
    for (int i = 0; i < lattice.cells_u; ++i)
        for (int j = 0; j < lattice.cells_v; ++j)
            for (const std::vector<Vec3>* nodes : {&lattice.foot, &lattice.top}) {
                const auto node = [&](int u, int v) {
                    return (*nodes)[lattice.index(i + u, j + v)];
                };
                const Vec3 mixed = node(0, 0) - node(1, 0) - node(0, 1) + node(1, 1);
                twist = std::max(twist, mixed.length() / 4);
            }
    return twist;
}

/// Cells along an axis that a coarse lattice calls for.
double cells_for(const ShellLattice& coarse, int axis, const ShellCells& limits) {
    double bend = twist_of(coarse), longest = 0;
    each_bend(coarse, axis, [&](std::size_t a, std::size_t b, std::size_t c) {
        for (const std::vector<Vec3>* nodes : {&coarse.foot, &coarse.top}) {
            const Vec3 first = (*nodes)[b] - (*nodes)[a], second = (*nodes)[c] - (*nodes)[b];
            // Of a chord over an arc the height is an eighth of the second difference.
            bend = std::max(bend, (second - first).length() / 8);
            longest = std::max({longest, first.length(), second.length()});
        }
    });
    const double finer = std::max(std::sqrt(bend / limits.deviation), longest / limits.longest);
    return std::max(2.0, std::ceil((axis == 0 ? coarse.cells_u : coarse.cells_v) * finer));
}

/// Cells along u and v of the coarse lattice, by which no knot span is stepped over.
std::pair<int, int> coarse_cells(const PatchGrid& grid, const ShellCells& limits) {
    constexpr int fewest = 16, in_span = 4;
    const Box2 domain = grid.domain();
    const auto cells = [&](const Vec2& end) { // along a border from the lower corner
        const int spans = grid.lines_through({domain.lower, end}) + 1;
        return std::min(std::max(fewest, in_span * spans), limits.most_along);
    };
    return {cells({domain.upper.x, domain.lower.y}), cells({domain.lower.x, domain.upper.y})};
}

} // namespace

Vec2 ShellLattice::lengths() const {
    Vec2 sum(0);
    for (int i = 0; i <= cells_u; ++i)
        for (int j = 0; j <= cells_v; ++j) {
            if (i > 0) sum.x += (foot[index(i, j)] - foot[index(i - 1, j)]).length();
            if (j > 0) sum.y += (foot[index(i, j)] - foot[index(i, j - 1)]).length();
        }
    return {sum.x / (cells_v + 1), sum.y / (cells_u + 1)};
}

ShellLattice shell_lattice(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                           double thickness, const ShellCells& cells) {
    const PatchGrid grid(model, model.faces[face]);
    const SampledFace sampled{model, grid, instance};
    const auto [coarse_u, coarse_v] = coarse_cells(grid, cells);
    ShellLattice lattice{instance, face, coarse_u, coarse_v, grid.domain()};
    sample(sampled, thickness, lattice);
    const double u = cells_for(lattice, 0, cells), v = cells_for(lattice, 1, cells);
    const double most = cells.most_along;
    lattice.limited = std::max(u, v) > most;
    lattice.cells_u = static_cast<int>(std::min(u, most));
    lattice.cells_v = static_cast<int>(std::min(v, most));
    sample(sampled, thickness, lattice);
    return lattice;
}

} // namespace keiko
