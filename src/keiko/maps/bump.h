#pragma once

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/maps/orange_peel.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

namespace keiko {

/// A surface whose places are raised by a height along its unit normal, the normal taken for
/// constant [Blinn1978]: position and derivatives up to the second.
SurfaceDerivatives raised(const SurfaceDerivatives& surface, const Vec3& normal,
                          const HeightJet& height);

/// Unit normal there: that of a surface with a unit normal and a height with this gradient.
Vec3 raised_normal(const Vec3& normal, const Vec3& gradient);

/// Normal that a normal map states in a frame: along the tangent, the bitangent and the unit
/// normal; a unit vector. `texel` holds its components, from -1 to 1 each.
Vec3 mapped_normal(const Rgb& texel, const Vec3& tangent, const Vec3& bitangent,
                   const Vec3& normal);

/// Unit tangent and bitangent at a unit normal, square to each other: the first along the direction
/// `along_u`, the second on the side of `along_v`.
struct MapTangents {
    MapTangents(const Vec3& along_u, const Vec3& along_v, const Vec3& normal)
        : tangent(square_to(along_u, normal).normalized()), bitangent(normal.cross(tangent)) {
        if (bitangent.dot(along_v) < 0) bitangent = -bitangent;
    }

    Vec3 tangent, bitangent;
};

} // namespace keiko
