#pragma once

#include "keiko/import/cad/surface_patches.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>

namespace keiko::cad {

/// The knot spans of a B-spline surface that overlap `domain`; those of a periodic surface are
/// repeated by whole periods as far as the domain reaches, those at an open border continued.
std::vector<SurfacePatch> spline_patches(const Geom_BSplineSurface& surface, const Box2& domain);

/// The one patch of a Bezier surface, continued where the domain goes beyond it.
std::vector<SurfacePatch> bezier_patches(const Geom_BezierSurface& surface, const Box2& domain);

} // namespace keiko::cad
