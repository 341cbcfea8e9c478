#pragma once

#include "uniform_spline.h"
#include <Geom_BezierSurface.hxx>
#include <gp_XY.hxx>

namespace keiko::fixtures {

/// A column and a row of a skin: one Bezier patch.
struct Cell {
    int column;
    int row;
    auto operator<=>(const Cell&) const = default;
};

/// Position in mm with the two first derivatives by the skin's parameters.
struct SkinPoint {
    gp_XYZ position;
    gp_XYZ du;
    gp_XYZ dv;
};

/// A grid of Bezier patches over [0, columns] x [0, rows], one patch a unit square. A closed skin
/// is periodic along the columns.
class Skin {
public:
    Skin(int columns, int rows, bool closed, const std::function<Net(Cell)>& patch_net);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool closed() const { return closed_; }
    const Handle(Geom_BezierSurface) & patch(Cell cell) const;

    /// The cell that holds uv; uv outside of an open skin goes to the nearest cell, whose
    /// polynomial simply carries on.
    Cell cell_of(gp_XY uv) const;
    /// The column as an index, also for a closed skin's column -1 or `columns`.
    int wrapped_column(int column) const;
    SkinPoint evaluate(gp_XY uv) const;

private:
    int columns_;
    int rows_;
    bool closed_;
    std::vector<Handle(Geom_BezierSurface)> patches_;
};

/// The skin of all spans of a uniform spline.
Skin skin_of(const UniformSpline& spline, bool closed);

/// OCCT surface over the unit square with this control net.
Handle(Geom_BezierSurface) bezier_surface(const Net& net);

} // namespace keiko::fixtures
