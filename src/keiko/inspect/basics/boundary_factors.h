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

/// Divides `field` by its boundary factors: the sides along which it is at most `tolerance`, each
/// with its multiplicity. The other zeros stay as they are.
std::vector<BoundaryFactor> divide_sides(BernsteinField& field, double tolerance);

} // namespace keiko
