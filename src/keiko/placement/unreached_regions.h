#pragma once

#include "keiko/placement/lamp_field.h"

#include <string_view>
#include <vector>

namespace keiko {

/// Why a place mirrors no lamp.
enum class UnreachedBecause {
    beyond_lamps, ///< its reflected ray passes beside all lamps
    blocked,      ///< it mirrors the body itself
    hidden        ///< lamps stand between it and the eye
};

/// "beyond the lamps", "mirrors the body", "hidden by lamps"
std::string_view name_of(UnreachedBecause reason);

/// A part of a picture that hangs together and mirrors no lamp.
struct UnreachedRegion {
    std::uint32_t view = 0; ///< which of the cameras
    UnreachedBecause because = UnreachedBecause::beyond_lamps;
    double share = 0;                 ///< of the weight of all pictures
    Vec3 place{0};                    ///< mm: the place on the surface nearest to its middle
    Box3 box;                         ///< mm, of its places on the surface
    std::vector<std::uint32_t> faces; ///< of the model, rising
    Box2 pixels;                      ///< where it is in the picture
};

/// The regions of at least `least_share`, the largest first.
std::vector<UnreachedRegion> unreached_regions(const LampField& field, double least_share = 0.002);

} // namespace keiko
