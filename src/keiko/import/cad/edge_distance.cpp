#include "keiko/import/cad/edge_distance.h"

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <algorithm>

namespace keiko::cad {

namespace {

double largest_distance(const TopoDS_Edge& edge, const TopoDS_Face& face, const PCurve& on_face,
                        bool anywhere) {
    double first = 0, last = 0, worst = 0;
    const auto in_space = BRep_Tool::Curve(edge, first, last);
    const auto surface = BRep_Tool::Surface(face);
    if (in_space.IsNull() || surface.IsNull()) return 0;
    constexpr int places = 32;
    for (int i = 0; i <= places; ++i) {
        const double share = double(i) / places;
        const gp_Pnt2d at =
            on_face.curve->Value(on_face.first + (on_face.last - on_face.first) * share);
        const gp_Pnt image = surface->Value(at.X(), at.Y());
        double distance = image.Distance(in_space->Value(first + (last - first) * share));
        if (anywhere && distance > worst) {
            for (const double end : {first, last})
                distance = std::min(distance, image.Distance(in_space->Value(end)));
            const GeomAPI_ProjectPointOnCurve feet(image, in_space, first, last);
            for (int k = 1; k <= feet.NbPoints(); ++k)
                distance = std::min(distance, feet.Distance(k));
        }
        worst = std::max(worst, distance);
    }
    return worst;
}

} // namespace

double distance_along_edge(const TopoDS_Edge& edge, const TopoDS_Face& face,
                           const PCurve& on_face) {
    return largest_distance(edge, face, on_face, false);
}

double distance_from_edge(const TopoDS_Edge& edge, const TopoDS_Face& face, const PCurve& on_face) {
    return largest_distance(edge, face, on_face, true);
}

} // namespace keiko::cad
