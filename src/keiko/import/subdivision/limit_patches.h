#pragma once

#include "keiko/import/subdivision/limit_table.h"

#include <vector>

namespace keiko::subdivision {

/// A Bezier patch of the limit surface.
struct LimitPatch {
    Box2 box;                 ///< which parameters of its base face it covers
    int degree = 3;           ///< in both directions
    std::vector<Vec3> points; ///< u outer, relative to the table's centre
};

/// The patches of a table by base face, each face's in a fixed order.
std::vector<std::vector<LimitTable::Index>> patches_by_face(const LimitTable& table);

/// The Bezier patches of one patch of four sides: itself, or a few strips beside a crease of finite
/// sharpness. Together those of a base face fill its parameters [0, 1]^2.
std::vector<LimitPatch> quad_patches(const LimitTable& table, LimitTable::Index index);

} // namespace keiko::subdivision
