#pragma once

#include "keiko/import/cad/curve_span.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

namespace keiko::cad {

/// The part [first, last] of a CAD curve as rational Bezier pieces: lines, conics and splines
/// exactly, all other kinds by an approximation whose tolerance is told. Periodic curves may be
/// asked for any range; the others are continued as their end pieces run. Throws Error for a
/// curve that cannot be converted.
CurveSpans<Vec3> curve_spans(const opencascade::handle<Geom2d_Curve>& curve, double first,
                             double last);
CurveSpans<Vec4> curve_spans(const opencascade::handle<Geom_Curve>& curve, double first,
                             double last);

} // namespace keiko::cad
