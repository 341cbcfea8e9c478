#pragma once

#include "keiko/math/bounds.h"
#include "keiko/radiosity/element_mesh.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace keiko {

/// Two halves of at least two triangles of a mesh, across the longest edge of the box of their
/// middles. With `by_normal` it is the box of their unit normals.
std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>> halves_of(
    const ElementMesh& mesh, std::span<const std::uint32_t> triangles, bool by_normal = false);

/// Elements of the triangles of each placed face: the number of its own for each triangle. All of a
/// face are halved until the diagonal of the box of a part is at most `allowed`(box) mm. Parts
/// above `smallest` mm are halved until their normals are within 45 degrees of the mean one.
std::vector<std::uint32_t> joined_triangles(const ElementMesh& mesh,
                                            const std::function<double(const Box3&)>& allowed,
                                            double smallest);

} // namespace keiko
