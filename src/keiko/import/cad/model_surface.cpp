#include "keiko/import/cad/model_surface.h"

#include <Geom_BSplineCurve.hxx>
#include <Standard_NotImplemented.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace keiko::cad {
namespace {

gp_Vec occt(const Vec3& v) {
    return {v.x, v.y, v.z};
}

[[noreturn]] void refuse() {
    throw Standard_NotImplemented("a surface of a model cannot do this");
}

} // namespace

ModelSurface::ModelSurface(const SurfaceModel& model, const Face& face)
    : model_(model), face_(face), grid_(model, face), domain_(grid_.domain()) {}

SurfaceDerivatives ModelSurface::derivatives(const Vec2& uv, int order) const {
    const auto [index, own] = place_at(model_, grid_, uv);
    const Patch& patch = model_.patches[index];
    SurfaceDerivatives s = evaluate(model_.patch(index), own, order);
    if (order == 0) return s;
    // The chain rule of u = map(t): d/dt = map' d/du.
    const double u1 = patch.map_u.derivative(own.x), v1 = patch.map_v.derivative(own.y);
    s.d[1][0] /= u1, s.d[0][1] /= v1;
    if (order == 1) return s;
    const double u2 = patch.map_u.second_derivative(own.x);
    const double v2 = patch.map_v.second_derivative(own.y);
    s.d[2][0] = (s.d[2][0] - s.d[1][0] * u2) / (u1 * u1);
    s.d[0][2] = (s.d[0][2] - s.d[0][1] * v2) / (v1 * v1);
    s.d[1][1] /= u1 * v1;
    return s;
}

Vec3 ModelSurface::position(const Vec2& uv) const {
    return derivatives(uv, 0).position();
}

opencascade::handle<Geom_Curve> ModelSurface::polyline(const Vec2& begin, const Vec2& end) const {
    constexpr int spans = 64;
    const double first = begin.x == end.x ? begin.y : begin.x;
    const double length = (end - begin).length();
    TColgp_Array1OfPnt points(1, spans + 1);
    TColStd_Array1OfReal knots(1, spans + 1);
    TColStd_Array1OfInteger multiplicities(1, spans + 1);
    multiplicities.Init(1);
    multiplicities(1) = multiplicities(spans + 1) = 2; // of a curve of degree 1 that has ends
    for (int i = 0; i <= spans; ++i) {
        const double share = double(i) / spans;
        points(i + 1).SetXYZ(occt(position(begin + (end - begin) * share)).XYZ());
        knots(i + 1) = first + length * share;
    }
    return new Geom_BSplineCurve(points, knots, multiplicities, 1);
}

void ModelSurface::Bounds(double& u1, double& u2, double& v1, double& v2) const {
    u1 = domain_.lower.x, u2 = domain_.upper.x, v1 = domain_.lower.y, v2 = domain_.upper.y;
}

void ModelSurface::D0(double u, double v, gp_Pnt& p) const {
    p.SetXYZ(occt(position({u, v})).XYZ());
}

void ModelSurface::D1(double u, double v, gp_Pnt& p, gp_Vec& du, gp_Vec& dv) const {
    const SurfaceDerivatives s = derivatives({u, v}, 1);
    p.SetXYZ(occt(s.position()).XYZ()), du = occt(s.du()), dv = occt(s.dv());
}

void ModelSurface::D2(double u, double v, gp_Pnt& p, gp_Vec& du, gp_Vec& dv, gp_Vec& duu,
                      gp_Vec& dvv, gp_Vec& duv) const {
    const SurfaceDerivatives s = derivatives({u, v}, 2);
    p.SetXYZ(occt(s.position()).XYZ()), du = occt(s.du()), dv = occt(s.dv());
    duu = occt(s.duu()), dvv = occt(s.dvv()), duv = occt(s.duv());
}

void ModelSurface::D3(double, double, gp_Pnt&, gp_Vec&, gp_Vec&, gp_Vec&, gp_Vec&, gp_Vec&, gp_Vec&,
                      gp_Vec&, gp_Vec&, gp_Vec&) const {
    refuse();
}

gp_Vec ModelSurface::DN(double u, double v, int order_u, int order_v) const {
    if (order_u + order_v > 2) refuse();
    const auto i = static_cast<std::size_t>(order_u), j = static_cast<std::size_t>(order_v);
    return occt(derivatives({u, v}, 2).d[i][j]);
}

void ModelSurface::UReverse() {
    refuse();
}
void ModelSurface::VReverse() {
    refuse();
}
double ModelSurface::UReversedParameter(double) const {
    refuse();
}
double ModelSurface::VReversedParameter(double) const {
    refuse();
}
opencascade::handle<Geom_Curve> ModelSurface::UIso(double u) const {
    return polyline({u, domain_.lower.y}, {u, domain_.upper.y});
}
opencascade::handle<Geom_Curve> ModelSurface::VIso(double v) const {
    return polyline({domain_.lower.x, v}, {domain_.upper.x, v});
}
void ModelSurface::Transform(const gp_Trsf&) {
    refuse();
}
opencascade::handle<Geom_Geometry> ModelSurface::Copy() const {
    return new ModelSurface(model_, face_);
}

} // namespace keiko::cad
