#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <array>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Motions of a body that an alignment leaves free, as orthogonal directions. They begin with those
/// nearest to the axes of the world.
struct FreeMotions {
    std::vector<Vec3> shifts; ///< unit directions
    std::vector<Vec3> turns;  ///< unit axes, wherever these lie; a screw counts as a turn

    /// Whether there is none.
    bool empty() const { return shifts.empty() && turns.empty(); }
};

/// The motions that orthonormal twists span: each a turn, then a shift.
FreeMotions free_motions(std::span<const std::array<double, 6>> twists);

} // namespace keiko
