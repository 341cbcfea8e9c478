#pragma once

#include "keiko/math/interval_set.h"

namespace keiko {

/// What a point sees of a light.
struct LightVisibility {
    /// Of a lamp's axis; of a source without extent the whole where it is seen, else nothing.
    IntervalSet axis{};
    /// 0 to 1, of what a lamp brings to the surface where nothing but lamps hides any of it; of
    /// models that ask for the whole width.
    double share = 1;
    /// 0 to 1, of what the cap that faces the point brings, of the same models.
    double cap = 1;

    bool operator==(const LightVisibility&) const = default;
};

} // namespace keiko
