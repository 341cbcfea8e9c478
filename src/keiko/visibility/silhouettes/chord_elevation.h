#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/visibility/nets/tangent_planes.h"

#include <span>

namespace keiko {

/// Sine of the least elevation at which a viewpoint sees a point of a convex body with these
/// corners. It is measured from the tangent plane with this unit normal, on either side of it; 0
/// where the plane cuts the body.
double least_elevation(const Viewpoint& viewpoint, const Vec3& normal,
                       std::span<const Vec3> corners);

/// Tangent plane at a viewpoint on a surface, and the least elevation above it that matters.
struct ViewpointHorizon {
    Vec3 normal{0};       ///< unit
    double elevation = 0; ///< sine of the least over the plane, 0 where it is cut
};

/// Bounds of a patch's homogeneous derivatives over a box of its parameters, by any positive
/// factor: component by component, middle and half width.
struct TangentBounds {
    /// Range of a vector, component by component.
    struct Range {
        Vec4 middle{0}; ///< of each component
        Vec4 half{0};   ///< half width of each component
    };
    Range along_u, along_v; ///< of the derivatives by u and by v
};
/// Bounds over [0, 1]^2 of a net, by the differences of neighbouring coefficients. Requires degrees
/// of at least 1.
TangentBounds tangent_bounds(const HomogeneousNet& net);

/// Steepest chord within the bounds alone, in their own axes.
double steepest_chord(const TangentBounds& bounds, const Vec3& point, const Vec3& normal);

/// Bound of the sine of the elevation at which a point of a patch sees any other over a box of its
/// parameters that holds the point: chords are mixtures of the patch's derivatives. `points` is
/// relative to the same place as `point`; 1 where the bound says nothing.
double steepest_chord(const HomogeneousNet& points, const Box2& uv, const Vec3& point,
                      const Vec3& normal);

} // namespace keiko
