#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/affine.h"
#include "keiko/math/bounds.h"

#include <vector>

namespace keiko {

/// A patch placed by an instance, with its middle moved to the origin, where numbers are small.
struct PlacedPatch {
    std::uint32_t index = 0;  ///< into SurfaceModel::patches
    std::vector<Vec4> points; ///< homogeneous, about `middle`
    Vec3 middle{0};           ///< world, mm
    double rounding = 0;      ///< mm: error of a homogeneous coordinate
    Box3 box;                 ///< world, of the control points

    PlacedPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed);
};

} // namespace keiko
