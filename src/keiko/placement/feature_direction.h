#pragma once

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/ray.h"

namespace keiko {

/// Which way a feature of the surface runs in the picture, and how much of a feature it is.
struct FeatureDirection {
    Vec2 along{0};       ///< unit, picture x and y; zero where there is none
    double strength = 0; ///< 1/mm: by how much the surface bends more across it than along it
};

/// Fillets, edges and character lines run along the principal direction of least curvature.
/// `mirrored` starts at the place and tells by its differentials how the picture sees it.
FeatureDirection feature_direction(const SurfaceDerivatives& surface, const Ray& mirrored);

} // namespace keiko
