#include "shape_pool.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <algorithm>
#include <stdexcept>

namespace keiko::fixtures {
namespace {

/// Different vertices of a body are millimetres apart, the same one computed twice 1e-10 mm.
constexpr double kSameVertex = 1e-5;

} // namespace

TopoDS_Vertex ShapePool::vertex(const gp_XYZ& position) {
    for (const auto& [place, vertex] : vertices_)
        if ((place - position).Modulus() < kSameVertex) return vertex;
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, gp_Pnt(position), Precision::Confusion());
    vertices_.emplace_back(position, vertex);
    return vertex;
}

TopoDS_Edge ShapePool::edge(const TrimPiece& piece) {
    const auto known = edges_.find(&piece);
    if (known != edges_.end()) return known->second;
    const double tolerance = std::max(Precision::Confusion(), 1.1 * piece.deviation);
    const TopoDS_Edge edge = bezier_edge(piece.poles, vertex(piece.poles.front()),
                                         vertex(piece.poles.back()), 0.0, 1.0, tolerance);
    edges_.emplace(&piece, edge);
    return edge;
}

TopoDS_Edge bezier_edge(const std::vector<gp_XYZ>& poles, const TopoDS_Vertex& start,
                        const TopoDS_Vertex& end, double first, double last, double tolerance) {
    TColgp_Array1OfPnt array(1, static_cast<int>(poles.size()));
    for (int k = 1; k <= array.Length(); ++k)
        array(k) = gp_Pnt(poles[static_cast<std::size_t>(k - 1)]);
    const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(array);
    BRepBuilderAPI_MakeEdge maker(curve, start, end, first, last);
    if (!maker.IsDone()) throw std::runtime_error("an edge does not meet its vertices");
    TopoDS_Edge edge = maker.Edge();
    const BRep_Builder builder;
    builder.UpdateEdge(edge, tolerance);
    builder.UpdateVertex(start, tolerance);
    builder.UpdateVertex(end, tolerance);
    return edge;
}

} // namespace keiko::fixtures
