#pragma once

#include "shape_pool.h"
#include <Geom_Surface.hxx>

namespace keiko::fixtures {

/// The whole surface as a face bounded by its own parameter lines, collapsed edges included.
NamedFace whole_face(const std::string& name, const Handle(Geom_Surface) & surface);

/// The part of a uniform spline over the knots [u0, u1] x [v0, v1] as one B-spline surface.
Handle(Geom_Surface) spline_surface(const UniformSpline& spline, int u0, int u1, int v0, int v1);

/// Control net of the polynomial patch over the unit square that equals `surface` at enough points.
/// It is exact, apart from rounding, if `surface` is a polynomial of these degrees.
Net polynomial_net(int degree_u, int degree_v,
                   const std::function<gp_XYZ(double u, double v)>& surface);

} // namespace keiko::fixtures
