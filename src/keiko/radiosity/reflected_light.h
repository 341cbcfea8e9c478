#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/radiosity/element_locator.h"
#include "keiko/radiosity/elements.h"
#include "keiko/radiosity/gather_rays.h"
#include "keiko/radiosity/radiosity_solution.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Reflected light of a solution at points of its scene.
class ReflectedLight {
public:
    /// Rays that gather light for a number.
    static constexpr int rays_of_numbers = 16384;

    /// Solution whose numbers of corners, faces and instances are in range, at `levels` of the
    /// lamps. `reflectances`: a face of the model. `tracer`: of what reflects and hides light in
    /// it.
    ReflectedLight(const RadiositySolution& solution, std::span<const Rgb> levels,
                   std::span<const Rgb> reflectances, SurfaceModel model, Tracer tracer);
    ReflectedLight(const ReflectedLight&) = delete;
    ReflectedLight& operator=(const ReflectedLight&) = delete;

    /// Illuminance in lx, without direct light, at a place of a surface on the side of the unit
    /// normal, interpolated between the corners of its triangle; nullopt without one.
    std::optional<Rgb> on_surface(const Root& place, const Vec3& normal) const;
    /// Illuminance in lx, without direct light, of any point, gathered by `rays` from the
    /// radiosities of the elements that they meet. Places nearer than an element is large gather
    /// anew what arrives there: it changes within the element. Throws Cancelled for a stop of its
    /// scope.
    Rgb gathered(const LightPoint& point, int rays = rays_of_numbers) const;

private:
    SurfaceModel model_;
    Tracer tracer_;
    double near_; ///< mm
    std::vector<Vec2> corners_;
    std::vector<SolvedTriangle> triangles_;
    ElementLocator locator_;
    GatherRays rays_;
    std::vector<BothSides> arriving_; ///< lx at each corner
    std::vector<Rgb> exitance_;       ///< lm/m2 by direct light, of fronts, then of backs
    std::vector<Rgb> reflectances_;   ///< likewise
};

} // namespace keiko
