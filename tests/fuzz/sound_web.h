#pragma once

#include "keiko/light/spotlight/photometric_web.h"

#include "tests/fuzz/fuzz_target.h"

#include <cmath>

namespace keiko::fuzz {

/// Whether a web answers every direction with a finite intensity, at most its largest.
inline void require_sound(const PhotometricWeb& web) {
    const double most = web.candela.largest();
    require(std::isfinite(most) && most >= 0, "intensities are finite and not negative");
    for (int v = 0; v <= 180; v += 15)
        for (int h = 0; h < 360; h += 15) {
            const double cd = intensity(web, web_direction(PhotometricType::c, v, h));
            require(cd >= 0 && cd <= most * (1 + 1e-12), "no direction is brighter than the table");
        }
    require(web.opening.x >= 0 && web.opening.y >= 0 && web.opening.z >= 0, "sizes are positive");
}

} // namespace keiko::fuzz
