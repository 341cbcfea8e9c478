#include "keiko/radiosity/element_mesh.h"

#include <algorithm>

namespace keiko {

double ElementMesh::longest_side(std::size_t triangle) const {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, (corner(triangle, (i + 1) % 3) - corner(triangle, i)).length());
    return longest;
}

} // namespace keiko
