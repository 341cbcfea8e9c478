#pragma once

#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/cage_lines.h"

namespace keiko::subdivision {

/// Remarks upon faces whose corners lie on a line or in a point. Throws Error for a cage that has
/// no other faces: its surface would be a line.
void check_areas(Cage& cage, const CageLines& lines);

} // namespace keiko::subdivision
