#include "keiko/workflow/surface_mesh.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/parallel.h"
#include "keiko/compare/alignment/closest_point_walk.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/model/patch_grid.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/mesh_in_worker.h"
#include "keiko/inspect/regularity/face_draft.h"
#include "keiko/raster/averaged_normals.h"
#include "keiko/raster/span_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace keiko {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::string unit_of(SurfaceField field) {
    switch (field) {
        case SurfaceField::gauss:
            return "1/mm2";
        case SurfaceField::draft:
            return "degrees";
        case SurfaceField::deviation:
            return "mm";
        default:
            return "1/mm";
    }
}

/// A corner of a face on the exact surface.
struct Corner {
    Vec3 position{0};
    Vec3 normal{0}; ///< outward; 0 where there is none
    std::optional<PrincipalCurvatures> curvatures{};
};

/// Evaluates a face of a model that is placed where it is.
class FaceEvaluator {
public:
    FaceEvaluator(const SurfaceModel& model, const Face& face)
        : model_(model), face_(face), grid_(model, face) {}

    Corner at(const Vec2& uv) const {
        const auto [patch, own] = place_at(model_, grid_, uv);
        const SurfaceDerivatives s = evaluate(model_.patch(patch), own, 2);
        Corner corner{s.position()};
        const auto normal = robust_normal(s, own);
        if (!normal) return corner;
        corner.normal = face_.reversed ? -*normal : *normal;
        corner.curvatures = reliable_curvatures(s, corner.normal);
        return corner;
    }

private:
    const SurfaceModel& model_;
    const Face& face_;
    PatchGrid grid_;
};

double curvature_of(SurfaceField field, const PrincipalCurvatures& k) {
    switch (field) {
        case SurfaceField::k1:
            return k.k1;
        case SurfaceField::k2:
            return k.k2;
        case SurfaceField::mean:
            return k.mean();
        case SurfaceField::gauss:
            return k.gaussian();
        default:
            return std::abs(k.k1) + std::abs(k.k2);
    }
}

double field_of(SurfaceField field, const Corner& corner, const Vec3& pull) {
    if (field == SurfaceField::draft)
        return corner.normal == Vec3(0) ? no_number : draft_angle(corner.normal, pull);
    return corner.curvatures ? curvature_of(field, *corner.curvatures) : no_number;
}

/// Adds the triangles of a face.
void append_face(const SurfaceModel& model, const Face& face, const FaceMesh& triangles,
                 const MeshOptions& options, SurfaceMesh& mesh) {
    const FaceEvaluator surface(model, face);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec2& uv : triangles.uv) {
        const Corner corner = surface.at(uv);
        mesh.positions.push_back(corner.position), mesh.normals.push_back(corner.normal);
        for (std::size_t f = 0; f < options.fields.size(); ++f)
            if (options.fields[f] != SurfaceField::deviation)
                mesh.fields[f].values.push_back(
                    field_of(options.fields[f], corner, options.pull.normalized()));
    }
    for (auto [a, b, c] : triangles.triangles) {
        if (face.reversed) std::swap(b, c);
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.faces.push_back(face.id);
    }
    mesh.deviation = std::max(mesh.deviation, triangles.deviation);
}

/// The deviation of each corner from another body.
std::vector<double> deviations(const std::vector<Vec3>& places, const MeshOptions& options,
                               const Job& job) {
    const ClosestPointQuery other(placed_model(options.against->model), job);
    constexpr double fiftieth = 0.02;
    const double reach = options.reach > 0
                             ? options.reach
                             : fiftieth * material_bounds(options.against->model, job).size();
    std::vector<double> values(places.size(), no_number);
    constexpr std::size_t chunk = 1024;
    parallel_for((places.size() + chunk - 1) / chunk, job, "deviation", [&](std::size_t c) {
        ClosestPointWalk walk(other, reach);
        for (std::size_t i = c * chunk; i < std::min(places.size(), (c + 1) * chunk); ++i)
            if (const auto foot = walk.next(places[i]))
                values[i] = foot->signed_distance(places[i]);
    });
    return values;
}

ModelMesh triangles_of(const SurfaceModel& model, const MeshOptions& options, const Job& job) {
    if (options.mesher == Mesher::spans)
        return span_mesh(model, options.deviation, job, options.limit);
    return mesh_in_worker(model, options.deviation, options.load, job);
}

void require_options(const MeshOptions& options) {
    if (!(options.deviation > 0 && std::isfinite(options.deviation)))
        throw FieldError("deviation", "must be above 0 mm");
    if (!is_finite(options.pull) || options.pull == Vec3(0))
        throw FieldError("pull", "must be a direction");
    const std::set<SurfaceField> fields(options.fields.begin(), options.fields.end());
    if (fields.size() < options.fields.size()) throw FieldError("field", "names a field twice");
    if (fields.count(SurfaceField::deviation) > 0 && !options.against)
        throw FieldError("against",
                         "is missing: the body that the field deviation is measured from");
}

} // namespace

const std::vector<SurfaceField>& every_surface_field() {
    static const std::vector<SurfaceField> all{
        SurfaceField::k1,       SurfaceField::k2,    SurfaceField::mean,     SurfaceField::gauss,
        SurfaceField::absolute, SurfaceField::draft, SurfaceField::deviation};
    return all;
}

std::string_view name_of(SurfaceField field) {
    constexpr std::array<std::string_view, 7> names{"k1",       "k2",    "mean",     "gauss",
                                                    "absolute", "draft", "deviation"};
    return names[static_cast<std::size_t>(field)];
}

SurfaceField surface_field_by_name(std::string_view name) {
    std::vector<std::string> names;
    for (const SurfaceField field : every_surface_field()) {
        if (name_of(field) == name) return field;
        names.emplace_back(name_of(field));
    }
    throw FieldError("field", in_quotes(name) + " is none of " + comma_list(names));
}

Mesher mesher_by_name(std::string_view name) {
    if (name == "opencascade") return Mesher::opencascade;
    if (name == "spans") return Mesher::spans;
    throw FieldError("mesher", "is opencascade or spans, not " + in_quotes(name));
}

CornerNormals corner_normals_by_name(std::string_view name) {
    if (name == "surface") return CornerNormals::surface;
    if (name == "averaged") return CornerNormals::averaged;
    throw FieldError("normals", "is surface or averaged, not " + in_quotes(name));
}

SurfaceMesh surface_mesh(const Scene& scene, const MeshOptions& options, const Job& job) {
    require_options(options);
    constexpr double meshing = 4, evaluating = 1;
    JobSteps steps(job, meshing + evaluating);
    const SurfaceModel model = placed_model(scene.model).model;
    const ModelMesh faces = triangles_of(model, options, steps.next(meshing));
    SurfaceMesh mesh;
    mesh.source = scene.model.source;
    for (const SurfaceField field : options.fields)
        mesh.fields.push_back({std::string(name_of(field)), unit_of(field), {}});
    for (std::size_t f = 0; f < faces.size(); ++f) {
        append_face(model, model.faces[f], faces[f], options, mesh);
        if (!faces[f].problem.empty())
            mesh.lost_faces.push_back(model.describe(model.faces[f]) + ": " + faces[f].problem);
    }
    if (options.normals == CornerNormals::averaged) mesh.normals = averaged_normals(mesh);
    if (mesh.positions.empty())
        throw Error(scene.model.source, "", "none of its faces can be divided into triangles");
    const Job to_evaluate = steps.next(evaluating);
    for (std::size_t f = 0; f < options.fields.size(); ++f)
        if (options.fields[f] == SurfaceField::deviation)
            mesh.fields[f].values = deviations(mesh.positions, options, to_evaluate);
    return mesh;
}

} // namespace keiko
