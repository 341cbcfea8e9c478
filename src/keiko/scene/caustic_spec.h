#pragma once

#include "keiko/base/export.h"

namespace KEIKO_API keiko {

/// Caustics of a scene: the light of points, spotlights, luminaires and the sun that smooth mirrors
/// and solid glass throw onto other surfaces (docs/theory/caustics.md).
struct CausticSpec {
    /// Cells a side of the grid of rays that each light sends to what mirrors and bends it, 8 to
    /// 2048. Cells over edges and folds are halved up to twice.
    int detail = 256;
    int interfaces = 4;       ///< most mirrors and interfaces on the way of light, 1 to 12
    double min_weight = 0.05; ///< light with a smaller share of what the lamp sent ends, 0.001 to 1

    bool operator==(const CausticSpec&) const = default;
};

} // namespace keiko
