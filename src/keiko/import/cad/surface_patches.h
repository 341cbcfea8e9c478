#pragma once

#include "keiko/geometry/bezier/parameter_map.h"
#include "keiko/math/bounds.h"

#include <Geom_Surface.hxx>

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

} // namespace keiko::cad
