#pragma once

#include "keiko/import/cad/curve_spans.h"
#include "keiko/import/cad/surface_patches.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>

#include <functional>
#include <vector>

namespace keiko::cad {

/// An axis of revolution with right-handed angles about `direction`, or left-handed ones.
struct Axis {
    Vec3 origin{0}, direction{0, 0, 1}; ///< unit direction
    bool left_handed = false;           ///< angles turn the other way
};

/// Surface of revolution: u is the angle, begin..end in radians; v runs along `profile`, which
/// is its meridian at u = 0.
std::vector<SurfacePatch> revolved(const Axis& axis, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile);

/// Linear extrusion: u runs along `profile`, v is the way along `direction` (any length).
std::vector<SurfacePatch> extruded(const Vec3& direction, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile);

/// The knot spans of a B-spline surface that overlap `domain`; those of a periodic surface are
/// repeated by whole periods as far as the domain reaches, those at an open border continued.
std::vector<SurfacePatch> spline_patches(const Geom_BSplineSurface& surface, const Box2& domain);

/// The one patch of a Bezier surface, continued where the domain goes beyond it.
std::vector<SurfacePatch> bezier_patches(const Geom_BezierSurface& surface, const Box2& domain);

/// A surface known by its points alone.
using SurfacePoint = std::function<Vec3(double u, double v)>;

/// Approximates a surface that has no rational form by polynomial patches of
/// degree 8 that interpolate it at Chebyshev-Lobatto nodes, halved until they are within
/// `tolerance` (mm) between the nodes. `cuts_u`, `cuts_v`: parameters where the surface may be
/// less than smooth, ends of the domain included, ascending. Patches of equal size meet exactly,
/// others within the tolerance. `approximated` is the deviation found, at least `tolerance`.
/// Throws Error when 1/64 of a cut interval is still not fine enough.
SurfacePatches interpolated_patches(const SurfacePoint& surface, const std::vector<double>& cuts_u,
                                    const std::vector<double>& cuts_v, double tolerance);

} // namespace keiko::cad
