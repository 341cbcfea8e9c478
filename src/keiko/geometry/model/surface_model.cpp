#include "keiko/geometry/model/surface_model.h"

#include <algorithm>

namespace keiko {
namespace {

template <class T>
std::uint32_t append(std::vector<T>& to, const std::vector<T>& from) {
    const auto offset = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), from.begin(), from.end());
    return offset;
}

void append(SurfaceModel& to, const SurfaceModel& from) {
    const auto id_offset = static_cast<std::uint32_t>(to.faces.size() + to.lost_faces.size());
    const std::uint32_t points = append(to.control_points, from.control_points);
    const std::uint32_t trim_points = append(to.trim_points, from.trim_points);
    const std::uint32_t patches = append(to.patches, from.patches);
    const std::uint32_t curves = append(to.trim_curves, from.trim_curves);
    const std::uint32_t loops = append(to.trim_loops, from.trim_loops);
    const std::uint32_t faces = append(to.faces, from.faces);
    const std::uint32_t files = append(to.files, files_of(from));
    const std::uint32_t edges = append(to.edges, from.edges);
    const std::uint32_t parts = append(to.parts, from.parts);
    const std::uint32_t instances = append(to.instances, from.instances);
    const std::uint32_t lost = append(to.lost_faces, from.lost_faces);
    const std::uint32_t irregular = append(to.irregular_patches, from.irregular_patches);
    const std::uint32_t repairs = append(to.repairs, from.repairs);
    append(to.diagnostics, from.diagnostics);

    for (auto& p : std::span(to.patches).subspan(patches)) p.face += faces, p.first_point += points;
    for (auto& c : std::span(to.trim_curves).subspan(curves)) {
        c.first_point += trim_points;
        if (c.edge != no_index) c.edge += edges;
    }
    for (auto& l : std::span(to.trim_loops).subspan(loops)) l.first_curve += curves;
    for (auto& f : std::span(to.faces).subspan(faces))
        f.id += id_offset, f.part += parts, f.first_patch += patches, f.first_loop += loops,
            f.file += files;
    for (auto& p : std::span(to.parts).subspan(parts)) p.first_face += faces;
    for (auto& i : std::span(to.instances).subspan(instances)) i.part += parts;
    for (auto& l : std::span(to.lost_faces).subspan(lost)) l.id += id_offset;
    for (auto& p : std::span(to.irregular_patches).subspan(irregular)) p.face += faces;
    for (auto& r : std::span(to.repairs).subspan(repairs)) r.face += id_offset;
}

Vec2 end_point(const BezierCurveView& curve, bool last) {
    const Vec3& p = last ? curve.points.back() : curve.points.front();
    return {p.x / p.z, p.y / p.z};
}

bool is_way_back(const BezierCurveView& before, const BezierCurveView& own) {
    return std::equal(before.points.begin(), before.points.end(), own.points.rbegin(),
                      own.points.rend());
}

/// True if the curve continues the one before it. The other side of a seam starts elsewhere, or
/// runs back.
bool continues(const SurfaceModel& model, std::uint32_t curve) {
    const BezierCurveView before = model.trim_curve(curve - 1), own = model.trim_curve(curve);
    return model.trim_curves[curve - 1].edge == model.trim_curves[curve].edge &&
           end_point(before, true) == end_point(own, false) && !is_way_back(before, own);
}

} // namespace

BezierPatchView SurfaceModel::patch(std::uint32_t index) const {
    const Patch& p = patches[index];
    const std::size_t count = (p.degree_u + std::size_t{1}) * (p.degree_v + std::size_t{1});
    return {p.degree_u, p.degree_v, std::span(control_points).subspan(p.first_point, count)};
}

BezierCurveView SurfaceModel::trim_curve(std::uint32_t index) const {
    const TrimCurve& c = trim_curves[index];
    return {std::span(trim_points).subspan(c.first_point, c.degree + 1u)};
}

std::span<const Patch> SurfaceModel::patches_of(const Face& face) const {
    return std::span(patches).subspan(face.first_patch, face.patch_count);
}

std::span<const TrimLoop> SurfaceModel::loops_of(const Face& face) const {
    return std::span(trim_loops).subspan(face.first_loop, face.loop_count);
}

std::span<const TrimCurve> SurfaceModel::curves_of(const TrimLoop& loop) const {
    return std::span(trim_curves).subspan(loop.first_curve, loop.curve_count);
}

std::string SurfaceModel::describe(const Face& face) const {
    std::string text = "face " + std::to_string(face.id);
    if (!face.name.empty()) text += " (" + face.name + ")";
    return text;
}

Vec2 SurfaceModel::face_parameters(std::uint32_t index, const Vec2& uv) const {
    const Patch& p = patches[index];
    return {p.map_u.to_face(uv.x), p.map_v.to_face(uv.y)};
}

Box3 hull_bounds(const SurfaceModel& model) {
    Box3 box;
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (const Patch& p : model.patches_of(model.faces[f])) {
                const auto index = static_cast<std::uint32_t>(&p - model.patches.data());
                for (const Vec4& point : model.patch(index).points)
                    box.extend(instance.transform.point(euclidean(point)));
            }
    }
    return box;
}

std::vector<std::string> files_of(const SurfaceModel& model) {
    return model.files.empty() ? std::vector{model.source} : model.files;
}

SurfaceModel merge(std::span<const SurfaceModel> models) {
    if (models.empty()) return {};
    SurfaceModel all = models.front();
    all.files = files_of(all);
    for (const SurfaceModel& next : models.subspan(1)) {
        append(all, next);
        all.source += ", " + next.source;
        if (all.format != next.format) all.format = "several formats";
        if (all.unit != next.unit) all.unit = "several units";
    }
    return all;
}

std::vector<std::vector<EdgeUse>> edge_uses(const SurfaceModel& model) {
    std::vector<std::vector<EdgeUse>> uses(model.edges.size());
    for (std::uint32_t f = 0; f < model.faces.size(); ++f)
        for (const TrimLoop& loop : model.loops_of(model.faces[f]))
            for (std::uint32_t i = 0; i < loop.curve_count; ++i) {
                const std::uint32_t curve = loop.first_curve + i;
                const std::uint32_t edge = model.trim_curves[curve].edge;
                if (edge == no_index) continue;
                if (i > 0 && continues(model, curve))
                    ++uses[edge].back().curve_count;
                else
                    uses[edge].push_back({f, curve, 1});
            }
    return uses;
}

SurfaceModel ground_plane(double z, const Box3& body) {
    constexpr double least = 1e5, times = 100;
    const double reach = std::max(least, times * body.size());
    const Vec3 middle = body.center();
    SurfaceModel model;
    model.source = model.format = "ground";
    for (const double x : {-reach, reach})
        for (const double y : {-reach, reach})
            model.control_points.emplace_back(middle.x + x, middle.y + y, z, 1);
    const ParameterMap map{ParameterMap::Kind::affine, 0, 1};
    model.patches.push_back({0, 0, 1, 1, map, map});
    Face face;
    face.id = 1;
    face.name = "ground";
    face.surface_kind = "plane";
    face.patch_count = 1;
    model.faces.push_back(face);
    model.parts.push_back({"ground", 0, 1});
    model.instances.push_back({0, "ground", {}});
    return model;
}

} // namespace keiko
