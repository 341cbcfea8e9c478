#include "keiko/import/cad/wire_order.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <array>

namespace keiko::cad {
namespace {

bool is_cycle(const std::vector<TopoDS_Edge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const TopoDS_Edge& next = edges[(i + 1) % edges.size()];
        if (!TopExp::LastVertex(edges[i], true).IsSame(TopExp::FirstVertex(next, true)))
            return false;
    }
    return true;
}

bool uses_an_edge_twice(const std::vector<TopoDS_Edge>& edges) {
    TopTools_MapOfShape seen;
    return std::any_of(edges.begin(), edges.end(),
                       [&](const TopoDS_Edge& edge) { return !seen.Add(edge); });
}

/// The face's parameters where an edge begins and ends.
std::array<double, 4> ends(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    gp_Pnt2d first, last;
    BRep_Tool::UVPoints(edge, face, first, last);
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(first, last);
    return {first.X(), first.Y(), last.X(), last.Y()};
}

/// Where a wire that uses an edge twice begins is up to the memory addresses of a run in
/// OpenCASCADE's reader. It shall begin at the same place in every run.
void begin_at_least_parameters(std::vector<TopoDS_Edge>& cycle, const TopoDS_Face& face) {
    const auto first = std::min_element(
        cycle.begin(), cycle.end(),
        [&](const TopoDS_Edge& a, const TopoDS_Edge& b) { return ends(a, face) < ends(b, face); });
    std::rotate(cycle.begin(), first, cycle.end());
}

} // namespace

std::vector<TopoDS_Edge> ordered_edges(const TopoDS_Wire& wire, const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> all, chained;
    for (TopExp_Explorer e(wire, TopAbs_EDGE); e.More(); e.Next())
        all.push_back(TopoDS::Edge(e.Current()));
    for (BRepTools_WireExplorer e(wire, face); e.More() && chained.size() <= all.size(); e.Next())
        chained.push_back(e.Current());
    std::vector<TopoDS_Edge>& edges = chained.size() == all.size() ? chained : all;
    if (uses_an_edge_twice(edges) && is_cycle(edges)) begin_at_least_parameters(edges, face);
    return edges;
}

} // namespace keiko::cad
