#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/radiosity/hemicube.h"
#include "keiko/radiosity/radiosity_solution.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace keiko {

/// Reflected light of a solution at points of its scene.
class ReflectedLight {
public:
    /// Solution whose numbers of corners are in range.
    explicit ReflectedLight(RadiositySolution solution);

    /// The solution.
    const RadiositySolution& solution() const { return solution_; }
    /// Illuminance in lx, without direct light, of a point of a surface on the side of its unit
    /// normal. It is interpolated between the corners of the nearest element whose normal or its
    /// opposite is within 60 degrees. A corner has the mean of the elements around, by their areas.
    /// nullopt without such an element, or if it is farther away than its longest side.
    std::optional<Rgb> on_surface(const Vec3& point, const Vec3& normal) const;
    /// Illuminance in lx, without direct light, of a point on no element, by its own hemicube, on
    /// this thread. Throws Cancelled for a stop of its scope.
    Rgb in_space(const Vec3& point, const Vec3& normal) const;
    /// Illuminance in lx by on_surface(), or else by in_space().
    Rgb arriving(const Vec3& point, const Vec3& normal) const;

private:
    RadiositySolution solution_;
    SurfaceMesh mesh_; ///< for the hemicube
    Hemicube cube_;
    BoxTree tree_;                                 ///< of the triangles
    std::vector<std::array<Rgb, 2>> corner_light_; ///< lx, of fronts and backs
};

} // namespace keiko
