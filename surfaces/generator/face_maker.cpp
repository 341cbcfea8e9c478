#include "face_maker.h"

#include "bernstein_fit.h"
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <stdexcept>

namespace keiko::fixtures {
namespace {

/// Knots -degree, ..., count, each once.
TColStd_Array1OfReal uniform_knots(int degree, int spans) {
    TColStd_Array1OfReal knots(1, spans + 2 * degree + 1);
    for (int k = 1; k <= knots.Length(); ++k) knots(k) = k - 1 - degree;
    return knots;
}

/// Control points of the polynomial curve through the samples.
std::vector<gp_XYZ> fitted_row(const std::vector<gp_XYZ>& samples) {
    std::vector<gp_XYZ> poles(samples.size());
    for (int axis = 1; axis <= 3; ++axis) {
        std::vector<double> values;
        for (const gp_XYZ& sample : samples) values.push_back(sample.Coord(axis));
        const std::vector<double> coefficients = bernstein_fit(values);
        for (std::size_t k = 0; k < poles.size(); ++k) poles[k].SetCoord(axis, coefficients[k]);
    }
    return poles;
}

} // namespace

NamedFace whole_face(const std::string& name, const Handle(Geom_Surface) & surface) {
    BRepBuilderAPI_MakeFace maker(surface, Precision::Confusion());
    if (!maker.IsDone()) throw std::runtime_error("no face " + name);
    return {name, maker.Face()};
}

Handle(Geom_Surface) spline_surface(const UniformSpline& spline, int u0, int u1, int v0, int v1) {
    TColgp_Array2OfPnt poles(1, spline.net.size_u(), 1, spline.net.size_v());
    for (int i = 0; i < spline.net.size_u(); ++i)
        for (int j = 0; j < spline.net.size_v(); ++j)
            poles(i + 1, j + 1) = gp_Pnt(spline.net(i, j));
    const TColStd_Array1OfReal knots_u = uniform_knots(spline.degree_u, spline.spans_u());
    const TColStd_Array1OfReal knots_v = uniform_knots(spline.degree_v, spline.spans_v());
    TColStd_Array1OfInteger once_u(1, knots_u.Length());
    TColStd_Array1OfInteger once_v(1, knots_v.Length());
    once_u.Init(1);
    once_v.Init(1);
    Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
        poles, knots_u, knots_v, once_u, once_v, spline.degree_u, spline.degree_v);
    surface->Segment(u0, u1, v0, v1);
    return Handle(Geom_Surface)(surface);
}

Net polynomial_net(int degree_u, int degree_v,
                   const std::function<gp_XYZ(double u, double v)>& surface) {
    const std::vector<double> us = fit_parameters(degree_u);
    const std::vector<double> vs = fit_parameters(degree_v);
    std::vector<std::vector<gp_XYZ>> along_v;
    for (const double u : us) {
        std::vector<gp_XYZ> samples;
        for (const double v : vs) samples.push_back(surface(u, v));
        along_v.push_back(fitted_row(samples));
    }
    Net net(degree_u + 1, degree_v + 1);
    for (int j = 0; j <= degree_v; ++j) {
        std::vector<gp_XYZ> samples;
        for (const auto& row : along_v) samples.push_back(row[static_cast<std::size_t>(j)]);
        const std::vector<gp_XYZ> column = fitted_row(samples);
        for (int i = 0; i <= degree_u; ++i) net(i, j) = column[static_cast<std::size_t>(i)];
    }
    return net;
}

} // namespace keiko::fixtures
