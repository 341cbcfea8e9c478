#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/line_field.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// A box of a patch's parameters that a line may pass through.
struct LineCell {
    Box2 uv;                 ///< patch parameters
    std::uint32_t level = 0; ///< index of a requested level
    /// True if the cell is proved: the field rises or falls strictly along one parameter, and each
    /// side along the other one is crossed at most once. The line is then one arc or absent, which
    /// the signs of the field at the corners decide, and has no loop inside.
    bool proved = false;
    bool graph_over_v = false; ///< the field is strict along u, so that the arc is u = g(v)
};

/// Options of line_cells.
struct LineCellOptions {
    /// Number of boxes of a patch that are tested before the rest is returned unproved. Many are
    /// needed around places where the field's gradient vanishes, as at poles and at saddles on the
    /// very level.
    std::size_t most_boxes = 20000;
    /// Smallest extent of a box, as a share of the patch in both parameters; smaller boxes are not
    /// cut.
    double least_extent = 1.0 / 4096;
    /// Smallest extent of a box in which the normal may vanish, as at poles and folds: there the
    /// field is 0 on every level.
    double least_singular_extent = 1.0 / 512;
    /// True for a box of patch parameters in which no line is wanted, as outside of the material.
    /// Empty: lines are wanted everywhere.
    std::function<bool(const Box2&)> unwanted = {};
};

/// Cells that together hold every wanted point of every level's line where the field's ray meets
/// the C-plane between the ends of its lamps. The patch's control points are in world coordinates.
/// Boxes are cut until bounds of the field by Taylor models exclude the level or prove the cell.
/// They are in the order of the search, which is the same for any thread count.
std::vector<LineCell> line_cells(const BezierPatchView& patch, const LineField& field,
                                 std::span<const double> levels,
                                 const LineCellOptions& options = {});

/// Cells with the zeros of a field.
struct FieldCells {
    std::vector<LineCell> cells; ///< of level 0
    std::vector<Box2> blank;     ///< where the field is 0 everywhere, to within rounding
};

/// Cells that together hold every zero of a polynomial field on a patch outside of `blank`, like
/// line_cells for the lines of lamps. Boxes are cut until the hulls of the coefficients exclude 0
/// or prove the cell. All cells are of level 0; the result is the same for any thread count.
FieldCells field_cells(const BernsteinField& field, const LineCellOptions& options = {});

} // namespace keiko
