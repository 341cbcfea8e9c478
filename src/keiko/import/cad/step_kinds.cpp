#include "keiko/import/cad/step_kinds.h"

#include <StepData_UndefinedEntity.hxx>
#include <StepGeom_Surface.hxx>
#include <StepSelect_StepType.hxx>
#include <StepShape_Block.hxx>
#include <StepShape_BooleanResult.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_FaceBasedSurfaceModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_HalfSpaceSolid.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_RightAngularWedge.hxx>
#include <StepShape_RightCircularCone.hxx>
#include <StepShape_RightCircularCylinder.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_Sphere.hxx>
#include <StepShape_Torus.hxx>

#include <algorithm>
#include <string_view>
#include <vector>

namespace keiko::cad {

namespace {

using Unknown = opencascade::handle<StepData_UndefinedEntity>;

/// Kinds of an entity that OpenCASCADE does not know; empty for all others.
std::vector<std::string_view> unknown_kinds(const StepEntity& entity) {
    std::vector<std::string_view> kinds;
    for (Unknown part = Unknown::DownCast(entity); !part.IsNull(); part = part->Next())
        kinds.emplace_back(part->StepType());
    return kinds;
}

bool any_contains(const std::vector<std::string_view>& kinds, std::string_view word) {
    return std::any_of(kinds.begin(), kinds.end(), [word](std::string_view kind) {
        return kind.find(word) != std::string_view::npos;
    });
}

/// Kinds whose name says that they have neither area nor volume [ISO10303-42, 46].
bool names_no_area(std::string_view kind) {
    static constexpr std::string_view words[] = {
        "ANNOTATION", "CALLOUT",   "CAMERA",      "CONTEXT", "COORDINATES_LIST",
        "MEASURE",    "PLACEMENT", "STYLED_ITEM", "SYMBOL",  "WIREFRAME"};
    static constexpr std::string_view ends[] = {"CURVE",     "CURVE_SET",   "CURVE_ON_SURFACE",
                                                "DIRECTION", "EDGE",        "EDGE_SET",
                                                "LINE",      "LOOP",        "PATH",
                                                "POINT",     "POINT_SET",   "POINT_ON_SURFACE",
                                                "TEXT",      "VECTOR",      "VERTEX",
                                                "WIRE",      "OPERATOR_3D", "_REPRESENTATION_ITEM"};
    // Which every item is.
    if (kind == "GEOMETRIC_REPRESENTATION_ITEM" || kind == "TOPOLOGICAL_REPRESENTATION_ITEM")
        return false;
    return std::any_of(std::begin(words), std::end(words),
                       [kind](std::string_view word) {
                           return kind.find(word) != std::string_view::npos;
                       }) ||
           std::any_of(std::begin(ends), std::end(ends), [kind](std::string_view end) {
               return kind.size() >= end.size() && kind.substr(kind.size() - end.size()) == end;
           });
}

bool is_primitive(const StepEntity& entity) {
    return is_a<StepShape_Block>(entity) || is_a<StepShape_RightAngularWedge>(entity) ||
           is_a<StepShape_RightCircularCone>(entity) ||
           is_a<StepShape_RightCircularCylinder>(entity) || is_a<StepShape_Sphere>(entity) ||
           is_a<StepShape_Torus>(entity);
}

} // namespace

std::string kind_of(const StepEntity& entity,
                    const opencascade::handle<StepData_StepModel>& model) {
    const auto unknown = unknown_kinds(entity);
    if (unknown.empty()) {
        StepSelect_StepType type;
        type.SetProtocol(model->Protocol());
        return type.Value(entity, model);
    }
    std::string text;
    for (const std::string_view kind : unknown) text.append(text.empty() ? "" : ",").append(kind);
    return text;
}

bool is_unknown_shape_representation(const StepEntity& entity) {
    return any_contains(unknown_kinds(entity), "SHAPE_REPRESENTATION");
}

bool must_hold_faces(const StepEntity& entity) {
    return is_a<StepShape_ConnectedFaceSet>(entity) || is_a<StepShape_SolidModel>(entity) ||
           is_a<StepShape_ShellBasedSurfaceModel>(entity) ||
           is_a<StepShape_FaceBasedSurfaceModel>(entity);
}

bool is_made_of_faces(const StepEntity& entity) {
    return is_a<StepShape_FaceSurface>(entity) ||
           (must_hold_faces(entity) &&
            (is_a<StepShape_ManifoldSolidBrep>(entity) || !is_a<StepShape_SolidModel>(entity)));
}

bool is_tessellated(const StepEntity& entity) {
    const auto kinds = unknown_kinds(entity);
    return any_contains(kinds, "TESSELLATED") || any_contains(kinds, "TRIANGULATED");
}

bool has_area(const StepEntity& entity) {
    if (const auto kinds = unknown_kinds(entity); !kinds.empty())
        return std::none_of(kinds.begin(), kinds.end(), names_no_area);
    return must_hold_faces(entity) || is_primitive(entity) || is_a<StepGeom_Surface>(entity) ||
           is_a<StepShape_Face>(entity) || is_a<StepShape_BooleanResult>(entity) ||
           is_a<StepShape_HalfSpaceSolid>(entity);
}

} // namespace keiko::cad
