#include "skin.h"

#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>

namespace keiko::fixtures {

Skin::Skin(int columns, int rows, bool closed, const std::function<Net(Cell)>& patch_net)
    : columns_(columns), rows_(rows), closed_(closed) {
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) patches_.push_back(bezier_surface(patch_net({i, j})));
}

const Handle(Geom_BezierSurface) & Skin::patch(Cell cell) const {
    const int column = wrapped_column(cell.column);
    return patches_.at(static_cast<std::size_t>(column * rows_ + cell.row));
}

int Skin::wrapped_column(int column) const {
    return closed_ ? (column % columns_ + columns_) % columns_ : column;
}

Cell Skin::cell_of(gp_XY uv) const {
    const int column = static_cast<int>(std::floor(uv.X()));
    const int row = static_cast<int>(std::floor(uv.Y()));
    return {closed_ ? column : std::clamp(column, 0, columns_ - 1), std::clamp(row, 0, rows_ - 1)};
}

SkinPoint Skin::evaluate(gp_XY uv) const {
    const Cell cell = cell_of(uv);
    gp_Pnt position;
    gp_Vec du;
    gp_Vec dv;
    patch(cell)->D1(uv.X() - cell.column, uv.Y() - cell.row, position, du, dv);
    return {position.XYZ(), du.XYZ(), dv.XYZ()};
}

Skin skin_of(const UniformSpline& spline, bool closed) {
    return Skin(spline.spans_u(), spline.spans_v(), closed,
                [&](Cell cell) { return bezier_net(spline, cell.column, cell.row); });
}

Handle(Geom_BezierSurface) bezier_surface(const Net& net) {
    TColgp_Array2OfPnt poles(1, net.size_u(), 1, net.size_v());
    for (int i = 0; i < net.size_u(); ++i)
        for (int j = 0; j < net.size_v(); ++j) poles(i + 1, j + 1) = gp_Pnt(net(i, j));
    return new Geom_BezierSurface(poles);
}

} // namespace keiko::fixtures
