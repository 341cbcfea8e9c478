#pragma once

#include "keiko/base/export.h"
#include "keiko/math/affine.h"
#include "keiko/math/vec.h"

#include <variant>

namespace KEIKO_API keiko {

/// Scratches along a parameter of the face.
enum class FaceDirection {
    u, ///< along curves of constant v
    v  ///< along curves of constant u
};

/// Scratches along a direction in space, as far as the surface has it.
struct SpaceDirection {
    Vec3 direction{1, 0, 0}; ///< of any length but 0

    bool operator==(const SpaceDirection&) const = default;
};

/// Scratches around an axis, as on a turned disc.
struct AroundAxis {
    Vec3 point{0};      ///< of the axis, mm
    Vec3 axis{0, 0, 1}; ///< of any length but 0

    bool operator==(const AroundAxis&) const = default;
};

/// Which way the scratches of a brushed surface run. Places are those of the model, before its
/// transform.
using ScratchDirection = std::variant<FaceDirection, SpaceDirection, AroundAxis>;

/// Scratches of a brushed surface: the facets are as rough along them as Roughness::width says.
struct Scratches {
    double across = 0.3;          ///< width of the distribution across them, above 0
    ScratchDirection direction{}; ///< which way they run

    bool operator==(const Scratches&) const = default;
};

/// Direction of scratches at a place of a surface (mm) with its tangents by the face's parameters,
/// of any length; 0 on an axis.
Vec3 direction_at(const ScratchDirection& scratches, const Vec3& place, const Vec3& du,
                  const Vec3& dv);

/// Scratches moved with their model.
ScratchDirection moved(const Affine& motion, const ScratchDirection& scratches);

} // namespace keiko
