#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/inspect/basics/line_cells.h"

namespace keiko {

struct FieldCells {
    std::vector<LineCell> cells;
    std::vector<Box2> blank; ///< where the field is 0 everywhere, to within rounding
};

/// Cells that together hold every zero of a polynomial field on a patch outside of `blank`, like
/// line_cells for the lines of lamps. Boxes are cut until the hulls of the coefficients exclude 0
/// or prove the cell. All cells are of level 0; the result is the same for any thread count.
FieldCells field_cells(const BernsteinField& field, const LineCellOptions& options = {});

} // namespace keiko
