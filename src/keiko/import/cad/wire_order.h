#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

#include <vector>

namespace keiko::cad {

/// Edges of a wire in the order in which they chain, or in the file's where OpenCASCADE finds no
/// such order. `face` is oriented forward and has all p-curves.
std::vector<TopoDS_Edge> ordered_edges(const TopoDS_Wire& wire, const TopoDS_Face& face);

} // namespace keiko::cad
