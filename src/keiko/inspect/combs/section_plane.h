#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <array>
#include <string>

namespace keiko {

/// The points p with normal . p = height; the normal is unit, the height mm.
struct SectionPlane {
    std::string name; ///< as requested, "y=120"
    Vec3 normal{0, 1, 0};
    double height = 0;
};

/// "x=MM", "y=MM", "z=MM" or "A,B,C=MM": a direction and the height along it. Throws Error for
/// others.
SectionPlane section_plane(const std::string& text);

/// The least and the largest height of a body's control points along a unit direction, mm.
std::array<double, 2> heights(const SurfaceModel& model, const Vec3& along);

} // namespace keiko
