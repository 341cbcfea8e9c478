#pragma once

#include "keiko/base/export.h"
#include "keiko/math/interval.h"
#include "keiko/math/vec.h"

#include <cstdint>
#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// A place of the visible geometry under a pixel of a picture, with what is proved of it.
struct PickedPlace {
    std::uint32_t face = 0; ///< as Face::id; 0: the ground
    Vec3 place{0};          ///< world, mm
    double bound = 0;       ///< mm: the exact place lies within this distance
    bool unique = true;     ///< the hit was proved to be the only one of its piece of surface
    Vec3 normal{0};         ///< unit, towards the eye
    /// Ranges that hold both principal curvatures at the exact place, 1/mm, the larger first:
    /// positive where the surface bends towards the eye. Infinite where nothing is proved, as
    /// beside poles.
    Interval k1, k2;
};

/// A picked place, "keiko-pick/1" of docs/file-formats.md; nullopt: no surface.
std::string pick_json(const std::optional<PickedPlace>& picked);

} // namespace keiko
