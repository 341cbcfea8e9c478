#pragma once

#include "trim_tracer.h"
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <map>
#include <string>

namespace keiko::fixtures {

struct NamedFace {
    std::string name;
    TopoDS_Face face;
};

/// The vertices and trim edges that the faces of one body share. Border edges belong to their
/// skin alone.
class ShapePool {
public:
    /// The vertex at `position`, made on first sight.
    TopoDS_Vertex vertex(const gp_XYZ& position);
    /// The edge of a trim piece, the same for every face that it bounds.
    TopoDS_Edge edge(const TrimPiece& piece);

private:
    std::vector<std::pair<gp_XYZ, TopoDS_Vertex>> vertices_;
    std::map<const TrimPiece*, TopoDS_Edge> edges_;
};

/// An edge from `start` to `end` along the Bezier curve of `poles`, over [first, last] of it.
TopoDS_Edge bezier_edge(const std::vector<gp_XYZ>& poles, const TopoDS_Vertex& start,
                        const TopoDS_Vertex& end, double first, double last, double tolerance);

} // namespace keiko::fixtures
