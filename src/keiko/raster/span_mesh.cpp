#include "keiko/raster/span_mesh.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/parameter_map.h"
#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/raster/face_cells.h"
#include "keiko/raster/mesh_budget.h"
#include "keiko/raster/second_derivative_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Share of a patch by which its trims are queried inside its border: loops often run along it,
/// and there a place is material or not by rounding.
constexpr double inset = 1e-6;
/// Halvings of a cell until only rounding is left of it.
constexpr int most_halvings = 80;

/// Divides one patch of a trimmed face.
class PatchMesher {
public:
    PatchMesher(const SurfaceModel& model, const TrimRegion& trims,
                const SecondDerivativeBounds& bounds, std::uint32_t patch, double deviation,
                MeshBudget& triangles, FaceMesh& mesh)
        : model_(model),
          trims_(trims),
          bounds_(bounds),
          patch_(patch),
          maps_(model.patches[patch]),
          deviation_(deviation),
          triangles_(triangles),
          mesh_(mesh) {}

    void add_cell(const Box2& uv, int halvings = most_halvings) {
        const TrimSide side = trims_.untrimmed()
                                  ? TrimSide::inside
                                  : trims_.classify({asked(uv.lower), asked(uv.upper)});
        if (side == TrimSide::inside) add_polygon(corners(uv));
        if (side == TrimSide::mixed) add_cut_cell(uv, halvings);
    }

private:
    Vec2 face(const Vec2& uv) const { return model_.face_parameters(patch_, uv); }
    /// Face parameters of the place where trims are queried.
    Vec2 asked(const Vec2& uv) const {
        return face({std::clamp(uv.x, inset, 1 - inset), std::clamp(uv.y, inset, 1 - inset)});
    }
    /// Anticlockwise in the plane of the parameters.
    static std::vector<Vec2> corners(const Box2& uv) {
        return {uv.lower, Vec2(uv.upper.x, uv.lower.y), uv.upper, Vec2(uv.lower.x, uv.upper.y)};
    }

    /// Cuts a cell along the chord of two cuts if all its trims lie near, or leaves those near one
    /// of its sides away; halves others while they are larger than the deviation.
    void add_cut_cell(const Box2& uv, int halvings) {
        const ParameterMetric longest = longest_steps(uv);
        const Box2 around{asked(uv.lower), asked(uv.upper)};
        const CutCell cell = material(uv);
        if (settle(off_chord(cell.cuts, around, longest))) return add_polygon(cell.polygon);
        if (settle(off_sides(around, longest))) return add_if_material(uv);
        const double size = longest.across(around.extent());
        const Vec2 lengths(longest.length({around.extent().x, 0}),
                           longest.length({0, around.extent().y}));
        if (halvings > 0 && size > deviation_) return add_halves(uv, lengths, halvings - 1);
        mesh_.deviation = std::max(mesh_.deviation, size);
        if (cell.polygon.size() > 2) return add_polygon(cell.polygon);
        add_if_material(uv);
    }

    /// True if trims may be left by so much, which the mesh then tells.
    bool settle(double off) {
        if (!(off <= deviation_)) return false;
        mesh_.deviation = std::max(mesh_.deviation, off);
        return true;
    }

    void add_if_material(const Box2& uv) {
        if (trims_.contains(face(uv.center()))) add_polygon(corners(uv));
    }

    /// Adds the halves of a cell along the parameter in which it is longer on the surface.
    void add_halves(const Box2& uv, const Vec2& lengths, int halvings) {
        const unsigned along = lengths.x >= lengths.y ? 0 : 1;
        Box2 lower = uv, upper = uv;
        lower.upper[along] = upper.lower[along] = uv.center()[along];
        add_cell(lower, halvings), add_cell(upper, halvings);
    }

    /// Bound of the distance of the cell's trims from the chord between its two cuts; infinite for
    /// other numbers of cuts, as no one curve joins those.
    double off_chord(const std::vector<Vec2>& cuts, const Box2& around,
                     const ParameterMetric& longest) const {
        if (cuts.size() != 2) return std::numeric_limits<double>::infinity();
        return trims_.most_off(around, asked(cuts[0]), asked(cuts[1]), longest);
    }

    /// Bound of their distance from a side that they are nearer to than the cell's middle is.
    double off_sides(const Box2& around, const ParameterMetric& longest) const {
        const std::vector<Vec2> ends = corners(around);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const Vec2 &a = ends[i], &b = ends[(i + 1) % ends.size()];
            const double off = trims_.most_off(around, a, b, longest);
            if (off < longest.length((a + b) / 2 - around.center())) least = std::min(least, off);
        }
        return least;
    }

    /// Metric of the face's parameters by which no step within the cell is shorter than on the
    /// surface.
    ParameterMetric longest_steps(const Box2& uv) const {
        const SurfaceDerivatives s = evaluate(model_.patch(patch_), uv.center(), 1);
        const Vec2 half = uv.extent() / 2;
        const double u = s.du().length() + bounds_.uu * half.x + bounds_.uv * half.y;
        const double v = s.dv().length() + bounds_.uv * half.x + bounds_.vv * half.y;
        const auto slowest = [](const ParameterMap& map, double from, double to) {
            const Interval rates = parameter_ranges(map, {from, to}).first;
            return std::min(std::abs(rates.low), std::abs(rates.high));
        };
        // Of steps at right angles; of others the sum of both is at most this much longer.
        return ParameterMetric(std::numbers::sqrt2 *
                               Vec2(u / slowest(maps_.map_u, uv.lower.x, uv.upper.x),
                                    v / slowest(maps_.map_v, uv.lower.y, uv.upper.y)));
    }

    /// The corners of a cell that are material, with the places where trim curves cross its sides.
    struct CutCell {
        std::vector<Vec2> polygon, cuts;
    };

    CutCell material(const Box2& uv) const {
        CutCell cell;
        const std::vector<Vec2> around = corners(uv);
        for (std::size_t i = 0; i < around.size(); ++i) {
            if (trims_.contains(asked(around[i]))) cell.polygon.push_back(around[i]);
            for (const Vec2& cut : cuts_between(around[i], around[(i + 1) % around.size()]))
                cell.polygon.push_back(cut), cell.cuts.push_back(cut);
        }
        return cell;
    }

    /// Crossings of trim curves with a side, which runs along one parameter, in the order from `a`
    /// to `b`.
    std::vector<Vec2> cuts_between(const Vec2& a, const Vec2& b) const {
        const unsigned fixed = a.x == b.x ? 0 : 1, moving = 1 - fixed;
        const double from = std::min(a[moving], b[moving]), to = std::max(a[moving], b[moving]);
        const ParameterMap& map = moving == 0 ? maps_.map_u : maps_.map_v;
        std::vector<Vec2> cuts;
        for (const double crossing : trims_.crossings(fixed, asked(a)[fixed])) {
            const double t = map.to_patch(crossing);
            if (!(t > from && t < to)) continue;
            cuts.push_back(a);
            cuts.back()[moving] = t;
        }
        if (a[moving] > b[moving]) std::reverse(cuts.begin(), cuts.end());
        return cuts;
    }

    /// Adds a convex polygon of patch parameters.
    void add_polygon(const std::vector<Vec2>& polygon) {
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
            triangles_.spend(1);
            mesh_.triangles.push_back(
                {corner(polygon[0]), corner(polygon[i]), corner(polygon[i + 1])});
        }
    }

    /// Index of a corner, which the cells around it share.
    std::uint32_t corner(const Vec2& uv) {
        const auto next = static_cast<std::uint32_t>(mesh_.uv.size());
        const auto [known, is_new] = corners_.try_emplace({uv.x, uv.y}, next);
        if (is_new) mesh_.uv.push_back(face(uv));
        return known->second;
    }

    const SurfaceModel& model_;
    const TrimRegion& trims_;
    const SecondDerivativeBounds& bounds_;
    std::uint32_t patch_;
    const Patch& maps_;
    double deviation_;
    MeshBudget& triangles_;
    FaceMesh& mesh_;
    std::map<std::pair<double, double>, std::uint32_t> corners_; ///< by patch parameters
};

FaceMesh mesh_of(const SurfaceModel& model, const Face& face, const FaceCells& cells,
                 double deviation, MeshBudget& triangles) {
    const TrimRegion trims(model, face);
    FaceMesh mesh;
    mesh.deviation = cells.deviation();
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        const SpanCells divided = cells.of(model.patches[p]);
        PatchMesher mesher(model, trims, cells.bounds(p - face.first_patch), p, deviation,
                           triangles, mesh);
        for (int i = 0; i < divided.u; ++i) {
            for (int j = 0; j < divided.v; ++j) mesher.add_cell(divided.box(i, j));
            check_stop();
        }
    }
    if (mesh.triangles.empty()) mesh.problem = "its trim loops leave no cell";
    return mesh;
}

} // namespace

ModelMesh span_mesh(const SurfaceModel& model, double deviation, const Job& job,
                    const TriangleLimit& limit) {
    MeshBudget cells(model, deviation, limit), triangles(model, deviation, limit);
    std::vector<std::optional<FaceCells>> divided(model.faces.size());
    parallel_for(divided.size(), job, "", [&](std::size_t f) {
        divided[f].emplace(model, model.faces[f], deviation, limit.most);
        cells.spend(divided[f]->count());
    });
    ModelMesh mesh(model.faces.size());
    parallel_for(mesh.size(), job, "mesh", [&](std::size_t f) {
        mesh[f] = mesh_of(model, model.faces[f], *divided[f], deviation, triangles);
    });
    return mesh;
}

} // namespace keiko
