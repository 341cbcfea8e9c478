#include "keiko/import/cad/offset_bases.h"

#include "keiko/import/cad/surface_patches.h"

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <sstream>
#include <vector>

namespace keiko::cad {
namespace {

using Spline = opencascade::handle<Geom_BSplineSurface>;

/// Readers change a base by removing or inserting knots.
bool has_same_knots(const Spline& a, const Spline& b) {
    return a->UDegree() == b->UDegree() && a->VDegree() == b->VDegree() &&
           a->NbUPoles() == b->NbUPoles() && a->NbVPoles() == b->NbVPoles() &&
           a->NbUKnots() == b->NbUKnots() && a->NbVKnots() == b->NbVKnots();
}

/// Places of each span between knots, and beside its ends.
std::vector<double> places(const TColStd_Array1OfReal& knots) {
    std::vector<double> result;
    for (int i = knots.Lower(); i < knots.Upper(); ++i)
        for (const double share : {1e-6, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1 - 1e-6})
            result.push_back(knots(i) + share * (knots(i + 1) - knots(i)));
    return result;
}

double error_at(const Geom_OffsetSurface& read, const Spline& base, double u, double v) {
    gp_Pnt point, found;
    gp_Vec along_u, along_v;
    base->D1(u, v, point, along_u, along_v);
    const gp_Vec normal = along_u.Crossed(along_v);
    if (!(normal.Magnitude() > 0)) return 0;
    read.D0(u, v, found);
    return found.Distance(point.Translated(normal.Normalized() * read.Offset()));
}

} // namespace

double offset_error(const Geom_OffsetSurface& read, const opencascade::handle<Geom_Surface>& base) {
    const Spline stated = Spline::DownCast(untrimmed(base));
    const Spline kept = Spline::DownCast(untrimmed(read.BasisSurface()));
    if (stated.IsNull() || kept.IsNull() || has_same_knots(stated, kept)) return 0;
    double worst = 0;
    for (const double u : places(stated->UKnots()))
        for (const double v : places(stated->VKnots()))
            worst = std::max(worst, error_at(read, stated, u, v));
    return worst;
}

opencascade::handle<Geom_OffsetSurface> offset_surface_of(const TopoDS_Shape& shape) {
    const TopExp_Explorer face(shape, TopAbs_FACE);
    if (!face.More()) return {};
    return opencascade::handle<Geom_OffsetSurface>::DownCast(
        untrimmed(BRep_Tool::Surface(TopoDS::Face(face.Current()))));
}

std::string smoothed_by(const std::string& surface, double error) {
    std::ostringstream text;
    text << "the reader smoothed a kink of its offset surface " << surface << ", by up to " << error
         << " mm";
    return text.str();
}

} // namespace keiko::cad
