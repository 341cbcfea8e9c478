#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"

#include <vector>

namespace keiko {

/// A side of a patch's parameters along which a field is 0.
struct BoundaryFactor {
    bool by_u = true;   ///< u is fixed, else v
    bool upper = false; ///< at 1, else at 0
    int times = 1;      ///< its multiplicity: 2 and more where the slope across it is 0 as well
};

/// Divides those sides out of `field` along which it is at most `tolerance`, as often as it is:
/// what is left has the same zeros otherwise.
std::vector<BoundaryFactor> divide_sides(BernsteinField& field, double tolerance);

} // namespace keiko
