#include "keiko/import/cad/p_curves.h"

#include "keiko/import/cad/surface_patches.h"

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Plane.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace keiko::cad {
namespace {

bool is_plane(const TopoDS_Face& face) {
    TopLoc_Location location;
    const opencascade::handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
    return !surface.IsNull() && untrimmed(surface)->IsKind(STANDARD_TYPE(Geom_Plane));
}

bool has_p_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0, last = 0;
    return !BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull();
}

bool used_twice(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    int uses = 0;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) uses += e.Current().IsSame(edge);
    return uses > 1;
}

} // namespace

std::vector<TopoDS_Edge> complete_p_curves(const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> built;
    const bool plane = is_plane(face);
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(e.Current());
        if (plane) {
            BRepLib::BuildPCurveForEdgeOnPlane(edge, face);
        } else if (!has_p_curve(edge, face)) {
            ShapeFix_Edge().FixAddPCurve(edge, face, used_twice(edge, face),
                                         BRep_Tool::Tolerance(edge));
            if (has_p_curve(edge, face)) built.push_back(edge);
        }
    }
    return built;
}

} // namespace keiko::cad
