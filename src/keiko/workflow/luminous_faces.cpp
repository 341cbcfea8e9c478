#include "keiko/workflow/luminous_faces.h"

#include "keiko/base/error.h"
#include "keiko/compare/alignment/placed_model.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/mesh_in_worker.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/math/bounds.h"
#include "keiko/render/shading/traced_lamp.h"
#include "keiko/workflow/luminous_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Placed faces of one instance that shine with one luminance.
struct LampFaces {
    std::uint32_t instance = 0;
    std::vector<std::uint32_t> faces; ///< rising
    bool is_uniform = true;           ///< no map varies the luminance
};

/// The luminous faces of a model, instance by instance, by luminance and by what varies it.
std::vector<LampFaces> lamp_faces(const SurfaceModel& model, std::span<const Material> materials) {
    std::vector<LampFaces> lamps;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const std::size_t first = lamps.size();
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            const Material& own = materials[f];
            if (own.emits == Rgb(0)) continue;
            const bool is_uniform = !has_emission_map(own);
            const auto found =
                std::find_if(lamps.begin() + static_cast<std::ptrdiff_t>(first), lamps.end(),
                             [&](const LampFaces& lamp) {
                                 return is_uniform && lamp.is_uniform &&
                                        materials[lamp.faces.front()].emits == own.emits;
                             });
            if (found == lamps.end())
                lamps.push_back({i, {f}, is_uniform});
            else
                found->faces.push_back(f);
        }
    }
    return lamps;
}

/// The faces of a lamp, placed.
PlacedModel placed_lamp(SurfaceModel model, const LampFaces& lamp) {
    model.instances = {model.instances[lamp.instance]};
    return placed_model(model, {}, lamp.faces);
}

std::vector<Vec3> control_points(const SurfaceModel& model, const Face& face) {
    std::vector<Vec3> points;
    for (std::uint32_t i = face.first_patch; i < face.first_patch + face.patch_count; ++i)
        for (const Vec4& p : model.patch(i).points) points.push_back(Vec3(p.x, p.y, p.z) / p.w);
    return points;
}

/// True if the control points of a face lie in a plane.
bool is_flat(const SurfaceModel& model, const Face& face) {
    constexpr double rounding = 1e-9; // of the size
    const std::vector<Vec3> points = control_points(model, face);
    Vec3 longest(0), normal(0);
    for (const Vec3& at : points)
        if ((at - points[0]).length2() > longest.length2()) longest = at - points[0];
    for (const Vec3& at : points)
        if (const Vec3 area = longest.cross(at - points[0]); area.length2() > normal.length2())
            normal = area;
    normal.normalize();
    return std::all_of(points.begin(), points.end(), [&](const Vec3& at) {
        return std::abs(normal.dot(at - points[0])) <= rounding * longest.length();
    });
}

bool is_flat(const SurfaceModel& model) {
    return std::all_of(model.faces.begin(), model.faces.end(),
                       [&](const Face& face) { return is_flat(model, face); });
}

/// True if panels have each other behind them.
bool is_convex(const std::vector<PolygonLight>& panels) {
    constexpr double rounding = 1e-9; // of the size
    Box3 box;
    for (const PolygonLight& panel : panels)
        for (const Vec3& corner : panel.corners) box.extend(corner);
    return std::all_of(panels.begin(), panels.end(), [&](const PolygonLight& panel) {
        const Vec3 normal = panel.normal();
        for (const PolygonLight& other : panels)
            for (const Vec3& corner : other.corners)
                if (normal.dot(corner - panel.corners[0]) > rounding * box.size()) return false;
        return true;
    });
}

/// mm, the second longest side of a model's box.
double second_extent(const SurfaceModel& model, const Job& job) {
    const Vec3 extent = material_bounds(model, job).extent();
    std::array<double, 3> sides{extent.x, extent.y, extent.z};
    std::sort(sides.begin(), sides.end());
    return sides[1];
}

/// Makes the lights of one body.
class BodyLamps {
public:
    BodyLamps(const SurfaceModel& body, std::span<const Material> materials,
              const LoadOptions& options, double deviation, const Job& job)
        : body_(body), materials_(materials), options_(options), deviation_(deviation), job_(job) {}

    std::vector<LightSource> of(const LampFaces& lamp) const {
        const PlacedModel placed = placed_lamp(body_, lamp);
        const bool curved = !is_flat(placed.model);
        if (lamp.is_uniform && curved)
            if (auto light = by_contour(placed.model, lamp)) return {std::move(*light)};
        std::vector<PolygonLight> panels = in_panels(placed, lamp);
        if (lamp.is_uniform && !curved && !is_convex(panels))
            if (auto light = by_contour(placed.model, lamp)) return {std::move(*light)};
        return {std::make_move_iterator(panels.begin()), std::make_move_iterator(panels.end())};
    }

private:
    const Material& material_of(const LampFaces& lamp) const {
        return materials_[lamp.faces.front()];
    }
    /// nullopt for faces that are no closed body.
    std::optional<ContourLight> by_contour(const SurfaceModel& placed,
                                           const LampFaces& lamp) const {
        auto body = std::make_shared<const TracedLamp>(placed, job_);
        if (!body->is_closed()) return std::nullopt;
        return ContourLight{std::move(body), material_of(lamp).emits};
    }
    std::vector<PolygonLight> in_panels(const PlacedModel& placed, const LampFaces& lamp) const {
        const SurfaceModel& model = placed.model;
        // A flat face is one panel, however many corners it has.
        constexpr double finer = 1.0 / 32;
        const double off = deviation_ * second_extent(model, job_) * (is_flat(model) ? finer : 1);
        const ModelMesh mesh = mesh_in_worker(model, off, options_, job_);
        const FaceParameters parameters(model);
        std::vector<PolygonLight> all;
        for (std::size_t f = 0; f < mesh.size(); ++f) {
            if (!mesh[f].problem.empty())
                throw Error(body_.source, body_.describe(model.faces[f]),
                            "its light is unknown: " + mesh[f].problem);
            for (PolygonLight& panel :
                 luminous_panels(model, model.faces[f], mesh[f], material_of(lamp), parameters))
                all.push_back(std::move(panel));
        }
        return all;
    }

    const SurfaceModel& body_;
    std::span<const Material> materials_;
    const LoadOptions& options_;
    double deviation_;
    const Job& job_;
};

} // namespace

std::vector<LightSource> luminous_faces(const SurfaceModel& body,
                                        std::span<const Material> materials,
                                        const LoadOptions& options, const Job& job,
                                        double deviation) {
    std::vector<LightSource> lights;
    const BodyLamps lamps(body, materials, options, deviation, job);
    for (const LampFaces& lamp : lamp_faces(body, materials))
        for (LightSource& light : lamps.of(lamp)) lights.push_back(std::move(light));
    return lights;
}

} // namespace keiko
