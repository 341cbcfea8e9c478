#include "keiko/inspect/structure_checks.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/structure/edge_structure.h"
#include "keiko/inspect/structure/face_structure.h"

#include <iterator>
#include <map>

namespace keiko {
namespace {

constexpr const char* no_spline = "the face is no spline surface of the file";
constexpr const char* no_corner = "each corner lies on an edge that is a point";
constexpr const char* one_span = "no parameter has two knot spans side by side";
constexpr const char* no_legs = "no row of control points has two legs";
constexpr const char* no_rows = "the control points of each row are one";
constexpr const char* one_curve = "no edge of the face has two curves";
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
           limits.degenerate_edge || limits.corner_angle || limits.width_ratio ||
           limits.control_turn || limits.control_twist || limits.control_ratio ||
           limits.control_distance;
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
    add(limits.width_ratio.has_value(), "G-SU-RN", of.width_ratio, one_span);
    add(limits.control_turn.has_value(), "KEIKO-NET-TURN", of.control_turn, no_legs);
    add(limits.control_twist.has_value(), "KEIKO-NET-TWIST", of.control_twist, no_rows);
    add(limits.control_ratio.has_value(), "KEIKO-NET-RATIO", of.control_ratio, no_legs);
    add(limits.control_distance.has_value(), "KEIKO-NET-POINTS", of.control_distance, no_rows);
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

using EdgesByFace = std::map<FaceKey, EdgeStructure>;

/// The edges of the faces in the scope, as far as their limits have one for them.
EdgesByFace edges_by_face(const ModelBorders& borders, std::span<const MeasuredFace> faces,
                          const FaceLimits& limits, const Job& job) {
    std::map<FaceKey, StructureLimits> of_faces;
    for (const MeasuredFace& face : faces) {
        const StructureLimits& own = limits.of({face.instance, face.face}).structure;
        const bool limited =
            own.edge_gap || own.edge_angle || own.edge_degree || own.edge_knot_distance;
        if (limited && face.in_scope) of_faces[{face.instance, face.face}] = own;
    }
    return edge_structures(borders, of_faces, job);
}

/// Adds the checks of the curves of a face's edges.
void add_edge_checks(const MeasuredFace& face, const StructureLimits& limits,
                     const EdgesByFace& edges, std::vector<Check>& checks) {
    const auto found = edges.find({face.instance, face.face});
    const EdgeStructure of = found == edges.end() ? EdgeStructure{} : found->second;
    const auto add = [&](bool limited, const char* code, const auto& worst, const char* reason) {
        if (limited) checks.push_back(check_of_structure(code, worst, reason));
    };
    add(limits.edge_gap.has_value(), "G-CU-LG", of.gap, "no loop of the face has two edges");
    add(limits.edge_angle.has_value(), "G-CU-NT", of.angle, one_curve);
    add(limits.edge_degree.has_value(), "G-CU-HD", of.degree, "the face has no edges");
    add(limits.edge_knot_distance.has_value(), "G-CU-IK", of.knot_distance, one_curve);
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
    const EdgesByFace curves = edges_by_face(borders, faces, limits, job);
    std::vector<Check> checks;
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        if (!faces[i].in_scope) continue;
        std::vector<Check>& of_face = of_faces[i];
        add_border_checks(borders, faces[i], limits_of(i), edges, of_face);
        add_edge_checks(faces[i], limits_of(i), curves, of_face);
        for (Check& check : of_face) check.face = i, check.faces = faces[i].name;
        std::move(of_face.begin(), of_face.end(), std::back_inserter(checks));
    }
    return checks;
}

} // namespace keiko
