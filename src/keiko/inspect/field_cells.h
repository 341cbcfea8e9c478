#pragma once

#include "keiko/inspect/line_cells.h"
#include "keiko/patch/bernstein_field.h"

namespace keiko {

/// Cells that together hold every zero of a polynomial field on a patch, as line_cells has them for
/// the lines of lamps: boxes are cut until the hulls of the coefficients exclude 0 or prove the
/// cell. What is 0 as far as rounding lets tell is no cell. Of level 0; the same for any thread
/// count.
std::vector<LineCell> field_cells(const BernsteinField& field, const LineCellOptions& options = {});

} // namespace keiko
