#include "keiko/inspect/structure_checks.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/structure/face_structure.h"

#include <iterator>
#include <map>

namespace keiko {
namespace {

constexpr const char* no_spline = "the face is no spline surface of the file";
constexpr const char* no_corner = "each corner lies on an edge that is a point";
constexpr const char* no_edge = "the face has no edge that is not a point";

/// A place of the material where one is known, else of the surface.
Vec3 place_of(const SurfaceModel& model, const MeasuredFace& face) {
    if (face.curvature) return face.curvature->largest.place;
    const std::uint32_t patch = model.faces[face.face].first_patch;
    return placed_derivatives(model, face.instance, patch, Vec2(0.5)).position();
}

/// The limits of knot spans alone.
bool limits_spans(const StructureLimits& limits) {
    return limits.degree || limits.spans || limits.knot_distance || limits.patch_edge ||
           limits.degenerate_edge || limits.corner_angle;
}

std::vector<Check> span_checks(const SurfaceModel& model, const MeasuredFace& face,
                               const StructureLimits& limits) {
    if (!limits_spans(limits)) return {};
    const bool known = has_spans(model.faces[face.face]);
    SpanStructure of;
    if (known) of = span_structure(model, face.instance, face.face, limits);
    for (auto* count : {&of.degree, &of.spans})
        if (*count) (*count)->place = place_of(model, face);
    std::vector<Check> checks;
    const auto add = [&](bool limited, const char* code, const auto& worst, const char* reason) {
        if (limited) checks.push_back(check_of_structure(code, worst, known ? reason : no_spline));
    };
    add(limits.degree.has_value(), "G-SU-HD", of.degree, "");
    add(limits.spans.has_value(), "KEIKO-SPANS", of.spans, "");
    add(limits.knot_distance.has_value(), "G-SU-IK", of.knot_distance, "");
    add(limits.patch_edge.has_value(), "G-SU-TI", of.patch_edge, no_edge);
    add(limits.degenerate_edge.has_value(), "G-SU-DC", of.degenerate_edge, "");
    add(limits.corner_angle.has_value(), "G-SU-DP", of.corner_angle, no_corner);
    return checks;
}

/// The shortest edges of all faces, by the limit that they are held to.
using EdgesByLimit = std::map<double, std::map<FaceKey, MeasuredValue>>;

EdgesByLimit edges_by_limit(const ModelBorders& borders, std::span<const MeasuredFace> faces,
                            const FaceLimits& limits, const Job& job) {
    EdgesByLimit edges;
    for (const MeasuredFace& face : faces) {
        const auto& limit = limits.of({face.instance, face.face}).structure.short_edge;
        if (limit && face.in_scope && !edges.contains(*limit))
            edges[*limit] = shortest_edges(borders, *limit, job);
    }
    return edges;
}

/// Adds the checks of the edges and the size of a face to those of its spans.
void add_border_checks(const ModelBorders& borders, const MeasuredFace& face,
                       const StructureLimits& limits, const EdgesByLimit& edges,
                       std::vector<Check>& checks) {
    const FaceKey key{face.instance, face.face};
    if (limits.short_edge) {
        const auto& of_limit = edges.at(*limits.short_edge);
        const auto found = of_limit.find(key);
        checks.push_back(check_of_structure(
            "G-CU-TI", found == of_limit.end() ? std::nullopt : std::optional(found->second),
            no_edge));
    }
    if (limits.small_face)
        checks.push_back(check_of_structure(
            "G-FA-TI", face_size(borders, key, place_of(borders.model, face), *limits.small_face),
            "the face has no borders"));
}

} // namespace

std::vector<Check> structure_checks(const ModelBorders& borders,
                                    std::span<const MeasuredFace> faces, const FaceLimits& limits,
                                    const Job& job) {
    const auto limits_of = [&](std::size_t i) -> const StructureLimits& {
        return limits.of({faces[i].instance, faces[i].face}).structure;
    };
    std::vector<std::vector<Check>> of_faces(faces.size());
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        if (faces[i].in_scope) of_faces[i] = span_checks(borders.model, faces[i], limits_of(i));
    });
    const EdgesByLimit edges = edges_by_limit(borders, faces, limits, job);
    std::vector<Check> checks;
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        if (!faces[i].in_scope) continue;
        std::vector<Check>& of_face = of_faces[i];
        add_border_checks(borders, faces[i], limits_of(i), edges, of_face);
        for (Check& check : of_face) check.face = i, check.faces = faces[i].name;
        std::move(of_face.begin(), of_face.end(), std::back_inserter(checks));
    }
    return checks;
}

} // namespace keiko
