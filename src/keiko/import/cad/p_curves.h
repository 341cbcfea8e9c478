#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <vector>

namespace keiko::cad {

/// Gives each edge of a face the curve on its surface that it lacks: on a plane the projection,
/// which OpenCASCADE would else compute anew whenever it is asked for it; on other surfaces one
/// that is fitted. Returns the edges of the latter. Changes edges that other faces may share, so
/// not two faces of a document at a time.
std::vector<TopoDS_Edge> complete_p_curves(const TopoDS_Face& face);

} // namespace keiko::cad
