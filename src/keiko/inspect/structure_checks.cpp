#include "keiko/inspect/structure_checks.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/structure/face_structure.h"

#include <iterator>

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

} // namespace

std::vector<Check> structure_checks(const ModelBorders& borders,
                                    std::span<const MeasuredFace> faces,
                                    const StructureLimits& limits, const Job& job) {
    std::vector<std::vector<Check>> of_faces(faces.size());
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        of_faces[i] = span_checks(borders.model, faces[i], limits);
    });
    std::map<FaceKey, MeasuredValue> edges;
    if (limits.short_edge) edges = shortest_edges(borders, *limits.short_edge, job);
    std::vector<Check> checks;
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        const FaceKey key{faces[i].instance, faces[i].face};
        std::vector<Check>& of_face = of_faces[i];
        if (limits.short_edge) {
            const auto found = edges.find(key);
            of_face.push_back(check_of_structure(
                "G-CU-TI", found == edges.end() ? std::nullopt : std::optional(found->second),
                no_edge));
        }
        if (limits.small_face)
            of_face.push_back(check_of_structure(
                "G-FA-TI",
                face_size(borders, key, place_of(borders.model, faces[i]), *limits.small_face),
                "the face has no borders"));
        for (Check& check : of_face) check.face = i, check.faces = faces[i].name;
        std::move(of_face.begin(), of_face.end(), std::back_inserter(checks));
    }
    return checks;
}

} // namespace keiko
