#include "keiko/import/cad/shape_places.h"

#include <TopLoc_Location.hxx>
#include <TopoDS_Iterator.hxx>

#include <cmath>

namespace keiko::cad {

namespace {

bool alike_inside(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    if (a.IsPartner(b)) return true;
    if (a.IsNull() || b.IsNull()) return false;
    if (a.ShapeType() != TopAbs_COMPOUND || b.ShapeType() != TopAbs_COMPOUND) return false;
    TopoDS_Iterator one(a, false, false), other(b, false, false);
    while (one.More() && other.More() && alike(one.Value(), other.Value()))
        one.Next(), other.Next();
    return !one.More() && !other.More();
}

} // namespace

gp_Trsf place_of(const TopoDS_Shape& shape) {
    return shape.Location().Transformation();
}

bool alike(const gp_Trsf& a, const gp_Trsf& b) {
    constexpr double rounding = 1e-9;
    for (int row = 1; row <= 3; ++row)
        for (int column = 1; column <= 4; ++column) {
            const double one = a.Value(row, column), other = b.Value(row, column);
            if (!(std::abs(one - other) <= rounding * (1 + std::abs(one)))) return false;
        }
    return true;
}

bool alike(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    return alike(place_of(a), place_of(b)) && alike_inside(a, b);
}

} // namespace keiko::cad
