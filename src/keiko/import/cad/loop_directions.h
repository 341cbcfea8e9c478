#pragma once

#include "keiko/import/cad/wire_chain.h"

namespace keiko::cad {

/// How many of a face's closed loops have their material on the right: outer loops that run
/// clockwise and holes that run anticlockwise, told by how they lie in each other.
std::size_t backward_loops(const std::vector<Chain>& loops);

} // namespace keiko::cad
