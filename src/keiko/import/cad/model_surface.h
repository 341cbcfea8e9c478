#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/model/patch_grid.h"

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace keiko::cad {

/// The exact surface of a face of a model as OpenCASCADE asks for it, in face parameters: its
/// mesher works on any surface that it can evaluate. Refers to the model. What would change it, and
/// what only a surface of OpenCASCADE's own kinds has, throws Standard_NotImplemented.
class ModelSurface : public Geom_Surface {
public:
    /// Surface of a face with patches.
    ModelSurface(const SurfaceModel& model, const Face& face);

    /// Rectangle of the face parameters.
    const Box2& domain() const { return domain_; }
    /// Point of face parameters, mm.
    Vec3 position(const Vec2& uv) const;

    void Bounds(double& u1, double& u2, double& v1, double& v2) const override;
    bool IsUClosed() const override { return false; }
    bool IsVClosed() const override { return false; }
    bool IsUPeriodic() const override { return false; }
    bool IsVPeriodic() const override { return false; }
    GeomAbs_Shape Continuity() const override { return GeomAbs_C0; }
    bool IsCNu(int order) const override { return order < 1; }
    bool IsCNv(int order) const override { return order < 1; }
    void D0(double u, double v, gp_Pnt& p) const override;
    void D1(double u, double v, gp_Pnt& p, gp_Vec& du, gp_Vec& dv) const override;
    void D2(double u, double v, gp_Pnt& p, gp_Vec& du, gp_Vec& dv, gp_Vec& duu, gp_Vec& dvv,
            gp_Vec& duv) const override;
    void D3(double u, double v, gp_Pnt& p, gp_Vec& du, gp_Vec& dv, gp_Vec& duu, gp_Vec& dvv,
            gp_Vec& duv, gp_Vec& duuu, gp_Vec& dvvv, gp_Vec& duuv, gp_Vec& duvv) const override;
    gp_Vec DN(double u, double v, int order_u, int order_v) const override;
    void UReverse() override;
    void VReverse() override;
    double UReversedParameter(double u) const override;
    double VReversedParameter(double v) const override;
    opencascade::handle<Geom_Curve> UIso(double u) const override;
    opencascade::handle<Geom_Curve> VIso(double v) const override;
    void Transform(const gp_Trsf& motion) override;
    opencascade::handle<Geom_Geometry> Copy() const override;

private:
    /// The surface and its derivatives by face parameters, up to `order` 2.
    SurfaceDerivatives derivatives(const Vec2& uv, int order) const;
    /// Points of a line of constant u or v, joined: OpenCASCADE takes boxes and lengths from it.
    opencascade::handle<Geom_Curve> polyline(const Vec2& begin, const Vec2& end) const;

    const SurfaceModel& model_;
    const Face& face_;
    PatchGrid grid_;
    Box2 domain_;
};

} // namespace keiko::cad
