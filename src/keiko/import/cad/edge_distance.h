#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace keiko::cad {

/// An edge's curve in the parameters of a face, between two of its own parameters.
struct PCurve {
    opencascade::handle<Geom2d_Curve> curve;
    double first = 0, last = 0; ///< first < last
};

/// mm: the largest distance of a p-curve's image on the face from the edge's curve in space, both
/// at the same share of their parameters. 0 without such a curve.
double distance_along_edge(const TopoDS_Edge& edge, const TopoDS_Face& face, const PCurve& on_face);

/// mm: the same from the nearest place of the edge's curve, whatever its parameter.
double distance_from_edge(const TopoDS_Edge& edge, const TopoDS_Face& face, const PCurve& on_face);

} // namespace keiko::cad
