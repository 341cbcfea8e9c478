#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/vec.h"

#include <string>
#include <variant>
#include <vector>

namespace keiko {

/// An ellipsoid: the places center + x u + y v + z w of the unit sphere.
struct EllipsoidShape {
    Vec3 center{0};        ///< mm
    Vec3 u{0}, v{0}, w{0}; ///< mm, conjugate half-diameters, not in a plane

    bool operator==(const EllipsoidShape&) const = default;
};

/// A cylinder, or a cone, whole or truncated.
struct FrustumShape {
    Vec3 from{0}, to{0};              ///< mm, centers of the rims, apart from each other
    double radius = 0, to_radius = 0; ///< mm, of the rims, from 0; not both are 0
    bool open = false;                ///< without the discs at its ends

    bool operator==(const FrustumShape&) const = default;
};

/// A flat round disc.
struct DiscShape {
    Vec3 center{0};       ///< mm
    Vec3 normal{0, 0, 1}; ///< unit
    double radius = 0;    ///< mm, > 0

    bool operator==(const DiscShape&) const = default;
};

/// A parallelogram: the places origin + x u + y v, x and y from 0 to 1. Its face is u x v.
struct PlaneShape {
    Vec3 origin{0};  ///< mm, a corner
    Vec3 u{0}, v{0}; ///< mm, the edges from there, not parallel

    bool operator==(const PlaneShape&) const = default;
};

/// A parallelepiped.
struct BoxShape {
    Vec3 origin{0};        ///< mm, a corner
    Vec3 u{0}, v{0}, w{0}; ///< mm, the edges from there, not in a plane; right-handed

    /// Its faces, outwards.
    std::vector<PlaneShape> faces() const;
    bool operator==(const BoxShape&) const = default;
};

/// A plane polygon, convex or not, whose outline neither crosses nor touches itself. Its face is
/// the one from which the corners run anticlockwise.
struct PolygonShape {
    std::vector<Vec3> corners; ///< mm, at least 3 in a plane

    /// The rectangle around it, its `u` along the first side, `v` to the left of it.
    PlaneShape around() const;
    bool operator==(const PolygonShape&) const = default;
};

/// A body or a face with a name of its own in geometry.
using PrimitiveShape =
    std::variant<EllipsoidShape, FrustumShape, DiscShape, PlaneShape, BoxShape, PolygonShape>;

/// mm2, of all faces: closed forms, of an ellipsoid by quadrature.
double surface_area(const PrimitiveShape& shape);

/// The exact patches of a primitive, its faces outwards: rational biquadratic octants of an
/// ellipsoid, quarters of a frustum, plane faces, those of discs trimmed by circles and those of
/// polygons by their sides.
SurfaceModel primitive_model(const PrimitiveShape& shape, const std::string& name);

} // namespace keiko
