#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

namespace KEIKO_API keiko {

/// Limit of the draft angle, the angle by which a face opens towards the direction in which a tool
/// is pulled off.
struct DraftLimit {
    double angle = 3;   ///< degrees, 0 to 90: the smallest one allowed
    Vec3 pull{0, 0, 1}; ///< unit

    bool operator==(const DraftLimit&) const = default;
};

} // namespace keiko
