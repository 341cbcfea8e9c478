#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace keiko {

/// Triangles of one face by its parameters. What they show is evaluated on the exact surface there.
struct FaceMesh {
    std::vector<Vec2> uv; ///< corners, in face parameters
    /// Indices of corners, counter-clockwise in the plane of the face parameters.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// mm, largest distance of the exact surface from the triangles, measured at the middles of
    /// these and of their edges. Or a proved bound of it, and of the distance of trim curves on the
    /// surface from their chords.
    double deviation = 0;
    std::string problem; ///< why there are no triangles; empty if there are
};

/// Triangles of a model's faces, one mesh a face.
using ModelMesh = std::vector<FaceMesh>;

} // namespace keiko
