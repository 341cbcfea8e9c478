#include "keiko/raster/span_mesh.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/geometry/bezier/patch_height.h"
#include "keiko/geometry/trim/trim_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace keiko {
namespace {

/// Parts of a patch a side over which derivatives are bounded: bounds of a part are tighter.
constexpr int parts = 4;
/// Share of a patch by which its trims are queried inside its border: loops often run along it,
/// and there a place is material or not by rounding.
constexpr double inset = 1e-6;
/// Halvings of a cell that trim curves cross in no simple way.
constexpr int most_halvings = 5;

Box2 cell_box(const SpanCells& cells, int i, int j) {
    return {Vec2(double(i) / cells.u, double(j) / cells.v),
            Vec2(double(i + 1) / cells.u, double(j + 1) / cells.v)};
}

/// Patches of a face with the same range of a face parameter have as many cells along it.
class FaceCells {
public:
    FaceCells(const SurfaceModel& model, const Face& face, double deviation) {
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
            bounds_.push_back(SecondDerivativeBounds::of(model.patch(p)));
            const SpanCells cells = bounds_.back().cells_within(deviation);
            const Patch& patch = model.patches[p];
            int &u = along_u_[range(patch.map_u)], &v = along_v_[range(patch.map_v)];
            u = std::max(u, cells.u), v = std::max(v, cells.v);
        }
        for (std::uint32_t p = 0; p < face.patch_count; ++p)
            deviation_ =
                std::max(deviation_, bounds_[p].deviation(of(model.patches[face.first_patch + p])));
    }

    SpanCells of(const Patch& patch) const {
        return {along_u_.at(range(patch.map_u)), along_v_.at(range(patch.map_v))};
    }
    double deviation() const { return deviation_; }

private:
    static std::pair<double, double> range(const ParameterMap& map) {
        return {map.to_face(0), map.to_face(1)};
    }

    std::map<std::pair<double, double>, int> along_u_, along_v_;
    std::vector<SecondDerivativeBounds> bounds_;
    double deviation_ = 0;
};

/// Divides one patch of a trimmed face.
class PatchMesher {
public:
    PatchMesher(const SurfaceModel& model, const TrimRegion& trims, std::uint32_t patch,
                double deviation, FaceMesh& mesh)
        : model_(model),
          trims_(trims),
          patch_(patch),
          maps_(model.patches[patch]),
          deviation_(deviation),
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

    void add_cut_cell(const Box2& uv, int halvings) {
        const auto [polygon, cuts] = material(uv);
        if (cuts.size() == 2 && (halvings == 0 || is_near_curve((cuts[0] + cuts[1]) / 2)))
            return add_polygon(polygon);
        if (halvings == 0) {
            if (trims_.contains(face(uv.center()))) add_polygon(corners(uv));
            return;
        }
        const Vec2 middle = uv.center();
        add_cell({uv.lower, middle}, halvings - 1), add_cell({middle, uv.upper}, halvings - 1);
        add_cell({Vec2(middle.x, uv.lower.y), Vec2(uv.upper.x, middle.y)}, halvings - 1);
        add_cell({Vec2(uv.lower.x, middle.y), Vec2(middle.x, uv.upper.y)}, halvings - 1);
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

    bool is_near_curve(const Vec2& uv) const {
        const SurfaceDerivatives s = evaluate(model_.patch(patch_), uv, 1);
        const ParameterMetric metric(s.du() / maps_.map_u.derivative(uv.x),
                                     s.dv() / maps_.map_v.derivative(uv.y));
        return trims_.nearest_curve(face(uv), metric, deviation_).has_value();
    }

    /// Adds a convex polygon of patch parameters.
    void add_polygon(const std::vector<Vec2>& polygon) {
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            mesh_.triangles.push_back(
                {corner(polygon[0]), corner(polygon[i]), corner(polygon[i + 1])});
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
    std::uint32_t patch_;
    const Patch& maps_;
    double deviation_;
    FaceMesh& mesh_;
    std::map<std::pair<double, double>, std::uint32_t> corners_; ///< by patch parameters
};

FaceMesh mesh_of(const SurfaceModel& model, const Face& face, double deviation) {
    const FaceCells cells(model, face, deviation);
    const TrimRegion trims(model, face);
    FaceMesh mesh;
    mesh.deviation = cells.deviation();
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        const SpanCells divided = cells.of(model.patches[p]);
        PatchMesher mesher(model, trims, p, deviation, mesh);
        for (int i = 0; i < divided.u; ++i)
            for (int j = 0; j < divided.v; ++j) mesher.add_cell(cell_box(divided, i, j));
    }
    if (mesh.triangles.empty()) mesh.problem = "its trim loops leave no cell";
    return mesh;
}

} // namespace

SecondDerivativeBounds SecondDerivativeBounds::of(const BezierPatchView& patch) {
    const std::array heights{PatchHeight(patch, {Vec3(1, 0, 0), 0}),
                             PatchHeight(patch, {Vec3(0, 1, 0), 0}),
                             PatchHeight(patch, {Vec3(0, 0, 1), 0})};
    SecondDerivativeBounds bounds;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
            Vec3 uu(0), uv(0), vv(0);
            for (unsigned k = 0; k < 3; ++k) {
                const auto slopes = heights[k].over(cell_box({parts, parts}, i, j)).slopes();
                uu[k] = slopes.xx.magnitude(), uv[k] = slopes.xy.magnitude();
                vv[k] = slopes.yy.magnitude();
            }
            constexpr double per_patch = parts * parts; // by a part's own parameters before
            bounds.uu = std::max(bounds.uu, uu.length() * per_patch);
            bounds.uv = std::max(bounds.uv, uv.length() * per_patch);
            bounds.vv = std::max(bounds.vv, vv.length() * per_patch);
        }
    return bounds;
}

double SecondDerivativeBounds::deviation(const SpanCells& cells) const {
    const double u = 1.0 / cells.u, v = 1.0 / cells.v;
    return (uu * u * u + 2 * uv * u * v + vv * v * v) / 8;
}

SpanCells SecondDerivativeBounds::cells_within(double most) const {
    SpanCells cells;
    constexpr int widest = 1 << 14; // a patch in more cells than pixels of any picture
    while (deviation(cells) > most && std::max(cells.u, cells.v) < widest) {
        const double by_u = uu / (double(cells.u) * cells.u);
        const double by_v = vv / (double(cells.v) * cells.v);
        int& finer = by_u >= by_v ? cells.u : cells.v;
        finer += 1 + finer / 16;
    }
    return cells;
}

ModelMesh span_mesh(const SurfaceModel& model, double deviation, const Job& job) {
    ModelMesh mesh(model.faces.size());
    parallel_for(mesh.size(), job, "mesh",
                 [&](std::size_t f) { mesh[f] = mesh_of(model, model.faces[f], deviation); });
    return mesh;
}

} // namespace keiko
