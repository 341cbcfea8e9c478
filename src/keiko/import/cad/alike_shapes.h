#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

namespace keiko::cad {

/// Where a shape lies in what holds it.
gp_Trsf place_of(const TopoDS_Shape& shape);

/// Whether two places are one, up to rounding.
bool alike(const gp_Trsf& a, const gp_Trsf& b);

/// Whether two shapes are one in the same place. Compounds of a document are not those that a
/// reader has made, but built anew of the same shapes in the same order.
bool alike(const TopoDS_Shape& a, const TopoDS_Shape& b);

} // namespace keiko::cad
