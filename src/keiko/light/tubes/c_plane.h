#pragma once

#include "keiko/light/tubes/tube_model.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

namespace keiko {

/// The plane that a row of parallel tube lamps hangs on (the C-plane of [NishitaTubes]; not a
/// photometric C-plane, whose angle is called c_angle). Lamps lie along u and are spaced along v.
struct CPlane {
    Vec3 origin{0};     ///< corner u = v = 0, mm
    Vec3 u{1000, 0, 0}; ///< edge along the lamps, mm; its length is the lamp length
    Vec3 v{0, 1000, 0}; ///< edge across the lamps, mm; made orthogonal to u on reading
    int lamps = 12;
    double pitch = 0;           ///< mm from axis to axis; 0: |v| / lamps. The comb is centred in v
    double diameter = 26;       ///< mm
    Rgb luminance{9000};        ///< cd/m2 of the tube's surface, colour included
    bool luminous_caps = false; ///< whether the tubes' end discs shine like the rest
    TubeModel diffuse = TubeModel::automatic; ///< what lights surfaces
    MirrorModel mirror = MirrorModel::tube;   ///< what mirrors show

    double spacing() const { return pitch > 0 ? pitch : v.length() / lamps; }
};

} // namespace keiko
