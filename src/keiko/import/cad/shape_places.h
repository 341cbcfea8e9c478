#pragma once

#include "keiko/math/affine.h"

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

namespace keiko::cad {

/// Map of points by a transformation of OpenCASCADE, its scale included.
inline Affine affine(const gp_Trsf& t) {
    Affine result;
    for (int i = 1; i <= 3; ++i)
        result.rows[static_cast<std::size_t>(i - 1)] = {t.Value(i, 1), t.Value(i, 2),
                                                        t.Value(i, 3)};
    result.translation = {t.Value(1, 4), t.Value(2, 4), t.Value(3, 4)};
    return result;
}

/// Place of a shape in what holds it.
gp_Trsf place_of(const TopoDS_Shape& shape);

/// Whether two places are one, up to rounding.
bool alike(const gp_Trsf& a, const gp_Trsf& b);

/// Whether two shapes are one in the same place. Compounds of a document are not those that a
/// reader has made, but built anew of the same shapes in the same order.
bool alike(const TopoDS_Shape& a, const TopoDS_Shape& b);

} // namespace keiko::cad
