#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/affine.h"
#include "keiko/math/bounds.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// A face placed by an instance.
struct PlacedFace {
    std::uint32_t instance = 0, face = 0; ///< into the arrays of SurfaceModel

    bool operator==(const PlacedFace&) const = default;
};

/// Every face of a model as its instances place it: by instance, then by face.
inline std::vector<PlacedFace> placed_faces(const SurfaceModel& model) {
    std::vector<PlacedFace> placed;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = 0; f < part.face_count; ++f)
            placed.push_back({i, part.first_face + f});
    }
    return placed;
}

/// Name of a placed face: "face 12 (fender-outer)". If the model has several instances, it is "face
/// 12 of nut", or "face 12 of nut, instance 3" if several instances have that name.
std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

/// Text between the names of the two faces at a seam.
constexpr std::string_view between_faces = " | ";
/// Names of the two faces at a seam: "face 1 | face 2".
std::string faces_at_seam(const SurfaceModel& model, const PlacedFace& a, const PlacedFace& b);
/// Name of a line of constant u or v inside a face: "face 1, inside at u = 0.25".
std::string line_inside_face(const SurfaceModel& model, const PlacedFace& of, bool constant_u,
                             double at);

/// Derivatives to order 3 by the patch parameters of a patch placed by an instance; world, mm.
SurfaceDerivatives placed_derivatives(const SurfaceModel& model, std::uint32_t instance,
                                      std::uint32_t patch, const Vec2& uv);

/// A patch placed by an instance, with its middle moved to the origin, where numbers are small.
struct PlacedPatch {
    std::uint32_t index = 0;  ///< into SurfaceModel::patches
    std::vector<Vec4> points; ///< homogeneous, about `middle`
    Vec3 middle{0};           ///< world, mm
    double rounding = 0;      ///< mm: error of a homogeneous coordinate
    Box3 box;                 ///< world, of the control points

    /// The patch with index `patch` of the model.
    PlacedPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed);
};

} // namespace keiko
