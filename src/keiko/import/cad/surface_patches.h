#pragma once

#include "keiko/geometry/bezier/parameter_map.h"
#include "keiko/import/cad/curve_spans.h"
#include "keiko/math/bounds.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Surface.hxx>

#include <functional>
#include <string>
#include <vector>

namespace keiko::cad {

/// One rational Bezier patch of a CAD surface and how it lies in the surface's parameters.
struct SurfacePatch {
    ParameterMap map_u;       ///< from 0 to 1 of the patch to the surface's u
    ParameterMap map_v;       ///< likewise to its v
    int degree_u = 0;         ///< along u
    int degree_v = 0;         ///< along v
    std::vector<Vec4> points; ///< homogeneous, u outer
};

/// Patches that cover a part of a CAD surface.
struct SurfacePatches {
    std::vector<SurfacePatch> patches; ///< cover that part together
    double approximated = 0;           ///< mm, how far they may be from the surface; 0 where exact
};

/// Patches of `surface` over `domain` (its own parameters): elementary and swept surfaces by their
/// formulas, splines by their spans (those that overlap the domain), all other kinds by an
/// approximation whose tolerance is returned. Throws Error when the domain is infinite or the
/// surface cannot be converted.
SurfacePatches surface_patches(const opencascade::handle<Geom_Surface>& surface,
                               const Box2& domain);

/// The surface under any trimming: what the p-curves' parameters belong to.
opencascade::handle<Geom_Surface> untrimmed(opencascade::handle<Geom_Surface> surface);

/// Periods of the parameters, 0 where there is none.
Vec2 periods(const Geom_Surface& surface);

/// The natural parameter rectangle; infinite where the surface is.
Box2 natural_domain(const Geom_Surface& surface);

/// "plane", "cylinder", "b-spline", ...
std::string surface_kind(const opencascade::handle<Geom_Surface>& surface);

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
/// others within the tolerance. `approximated` is the deviation found.
/// Throws Error when 1/64 of a cut interval is still not fine enough.
SurfacePatches interpolated_patches(const SurfacePoint& surface, const std::vector<double>& cuts_u,
                                    const std::vector<double>& cuts_v, double tolerance);

} // namespace keiko::cad
