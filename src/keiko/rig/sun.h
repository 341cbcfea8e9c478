#pragma once

#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

namespace keiko {

/// Parallel light.
struct Sun {
    Vec3 direction{0, 0, -1}; ///< the way the light goes; of any length but 0
    Rgb illuminance{60000};   ///< lx on a surface across the light, past the air; colour included

    /// Unit vector towards the light.
    Vec3 towards() const { return direction / -direction.length(); }
    /// A place on the way to it, mm, so far off that nothing in a scene lies beyond.
    Vec3 seen_from(const Vec3& point) const { return point + towards() * 1e7; }
};

} // namespace keiko
