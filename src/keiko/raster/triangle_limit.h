#pragma once

#include "keiko/base/export.h"

#include <cstddef>

namespace KEIKO_API keiko {

/// Triangles of meshes by spans at most: some 5 GB while a picture of them is made.
constexpr std::size_t most_span_triangles = 50'000'000;

/// Limit of the triangles that are kept at once.
struct TriangleLimit {
    std::size_t most = most_span_triangles; ///< of all meshes together, up to 1e9
    std::size_t beside = 0;                 ///< of these, triangles of other meshes
};

} // namespace keiko
