#pragma once

#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/cage_statements.h"

namespace keiko::subdivision {

/// Throws Error when an edge has more than two faces or two that run the same way along it. A
/// vertex where several fans of faces touch is non-manifold too, but harmless: it is sharp for
/// ever. Each fan gets a copy of it as an infinitely sharp corner, which is the same surface.
/// Creases that are no edges are dropped and remarked upon.
void make_manifold(Cage& cage, const CageLines& lines);

/// Remarks upon faces whose corners lie on a line or in a point. Throws Error for a cage that has
/// no other faces: its surface would be a line.
void check_areas(Cage& cage, const CageLines& lines);

} // namespace keiko::subdivision
