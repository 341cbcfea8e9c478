#include "keiko/import/cad/surface_patches.h"

#include "keiko/base/error.h"
#include "keiko/import/cad/curve_spans.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_SweptSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>

#include <cmath>

namespace keiko::cad {
namespace {

/// mm. A tenth of a micrometre: far below what a reflection can show.
constexpr double approximation_tolerance = 1e-4;

using SurfaceHandle = opencascade::handle<Geom_Surface>;

Vec3 vector(const gp_XYZ& p) {
    return {p.X(), p.Y(), p.Z()};
}
Vec4 homogeneous(const Vec3& p, double w) {
    return {p.x, p.y, p.z, w};
}

template <class Kind>
opencascade::handle<Kind> as(const SurfaceHandle& surface) {
    return opencascade::handle<Kind>::DownCast(surface);
}

/// The frame of an elementary surface: meridian points are origin + r x + h z.
struct Frame {
    Vec3 origin, x, z;
    Axis axis;

    explicit Frame(const gp_Ax3& ax)
        : origin(vector(ax.Location().XYZ())),
          x(vector(ax.XDirection().XYZ())),
          z(vector(ax.Direction().XYZ())),
          axis{origin, z, !ax.Direct()} {}

    Vec4 meridian(double r, double h, double w = 1) const {
        return homogeneous(origin * w + x * r + z * h, w);
    }
};

CurveSpan<Vec4> meridian_line(const Frame& frame, const Box2& domain, const Vec2& start,
                              const Vec2& per_v) {
    const auto at = [&](double v) {
        return frame.meridian(start.x + per_v.x * v, start.y + per_v.y * v);
    };
    return {{ParameterMap::Kind::affine, domain.lower.y, domain.upper.y},
            {at(domain.lower.y), at(domain.upper.y)}};
}

/// Circle of radius `minor` in the meridian plane, centred `major` away from the axis.
std::vector<CurveSpan<Vec4>> meridian_circle(const Frame& frame, const Box2& domain, double major,
                                             double minor) {
    std::vector<CurveSpan<Vec4>> spans;
    for (const UnitArc& arc : circle_arcs(domain.lower.y, domain.upper.y)) {
        CurveSpan<Vec4> span{arc.map, {}};
        for (const Vec3& p : arc.points)
            span.points.push_back(frame.meridian(major * p.z + minor * p.x, minor * p.y, p.z));
        spans.push_back(std::move(span));
    }
    return spans;
}

std::vector<SurfacePatch> turned(const Frame& frame, const Box2& domain,
                                 const std::vector<CurveSpan<Vec4>>& meridian) {
    return revolved(frame.axis, domain.lower.x, domain.upper.x, meridian);
}

std::vector<SurfacePatch> plane(const Geom_Plane& s, const Box2& domain) {
    const gp_Ax3& ax = s.Position();
    const Vec3 origin = vector(ax.Location().XYZ()), x = vector(ax.XDirection().XYZ());
    const CurveSpan<Vec4> line{
        {ParameterMap::Kind::affine, domain.lower.x, domain.upper.x},
        {homogeneous(origin + x * domain.lower.x, 1), homogeneous(origin + x * domain.upper.x, 1)}};
    return extruded(vector(ax.YDirection().XYZ()), domain.lower.y, domain.upper.y, {line});
}

SurfacePatches revolution(const Geom_SurfaceOfRevolution& s, const Box2& domain) {
    const auto profile = curve_spans(s.BasisCurve(), domain.lower.y, domain.upper.y);
    const Axis axis{vector(s.Axis().Location().XYZ()), vector(s.Axis().Direction().XYZ())};
    return {revolved(axis, domain.lower.x, domain.upper.x, profile.spans), profile.approximated};
}

SurfacePatches extrusion(const Geom_SurfaceOfLinearExtrusion& s, const Box2& domain) {
    const auto profile = curve_spans(s.BasisCurve(), domain.lower.x, domain.upper.x);
    return {extruded(vector(s.Direction().XYZ()), domain.lower.y, domain.upper.y, profile.spans),
            profile.approximated};
}

/// The knots of a spline along u or v, or of the spline that is swept along the other; else none.
std::vector<double> knots(const SurfaceHandle& surface, bool along_u) {
    std::vector<double> result;
    if (const auto spline = as<Geom_BSplineSurface>(surface))
        for (int i = 1; i <= (along_u ? spline->NbUKnots() : spline->NbVKnots()); ++i)
            result.push_back(along_u ? spline->UKnot(i) : spline->VKnot(i));
    const auto swept = as<Geom_SweptSurface>(surface);
    const bool is_profile = along_u != surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution));
    if (swept.IsNull() || !is_profile) return result;
    opencascade::handle<Geom_Curve> curve = swept->BasisCurve();
    while (const auto trimmed = opencascade::handle<Geom_TrimmedCurve>::DownCast(curve))
        curve = trimmed->BasisCurve();
    if (const auto spline = opencascade::handle<Geom_BSplineCurve>::DownCast(curve))
        for (int i = 1; i <= spline->NbKnots(); ++i) result.push_back(spline->Knot(i));
    return result;
}

/// Parameters inside [begin, end] where a spline or swept surface may be less than smooth, with
/// both ends.
std::vector<double> cuts(const SurfaceHandle& surface, bool along_u, double begin, double end) {
    std::vector<double> result{begin};
    const double period = along_u ? periods(*surface).x : periods(*surface).y;
    const std::vector<double> of_one_turn = knots(surface, along_u);
    for (int turn = period > 0 ? -2 : 0; turn <= (period > 0 ? 2 : 0); ++turn)
        for (const double at : of_one_turn) {
            const double knot = at + turn * period, slack = 1e-9 * (end - begin);
            if (knot > result.back() + slack && knot < end - slack) result.push_back(knot);
        }
    result.push_back(end);
    return result;
}

/// Approximation of offset and procedural surfaces, known by their points alone.
SurfacePatches approximation(const SurfaceHandle& surface, const Box2& domain) {
    const auto point = [&](double u, double v) {
        gp_Pnt p;
        surface->D0(u, v, p);
        return vector(p.XYZ());
    };
    const auto offset = as<Geom_OffsetSurface>(surface);
    const SurfaceHandle basis = offset ? untrimmed(offset->BasisSurface()) : surface;
    return interpolated_patches(point, cuts(basis, true, domain.lower.x, domain.upper.x),
                                cuts(basis, false, domain.lower.y, domain.upper.y),
                                approximation_tolerance);
}

SurfacePatches convert(const SurfaceHandle& surface, const Box2& domain) {
    if (const auto s = as<Geom_Plane>(surface)) return {plane(*s, domain)};
    if (const auto s = as<Geom_CylindricalSurface>(surface)) {
        const Frame frame(s->Position());
        return {turned(frame, domain, {meridian_line(frame, domain, {s->Radius(), 0}, {0, 1})})};
    }
    if (const auto s = as<Geom_ConicalSurface>(surface)) {
        const Frame frame(s->Position());
        const Vec2 per_v(std::sin(s->SemiAngle()), std::cos(s->SemiAngle()));
        return {turned(frame, domain, {meridian_line(frame, domain, {s->RefRadius(), 0}, per_v)})};
    }
    if (const auto s = as<Geom_SphericalSurface>(surface)) {
        const Frame frame(s->Position());
        return {turned(frame, domain, meridian_circle(frame, domain, 0, s->Radius()))};
    }
    if (const auto s = as<Geom_ToroidalSurface>(surface)) {
        const Frame frame(s->Position());
        return {turned(frame, domain,
                       meridian_circle(frame, domain, s->MajorRadius(), s->MinorRadius()))};
    }
    if (const auto s = as<Geom_SurfaceOfRevolution>(surface)) return revolution(*s, domain);
    if (const auto s = as<Geom_SurfaceOfLinearExtrusion>(surface)) return extrusion(*s, domain);
    if (const auto s = as<Geom_BezierSurface>(surface)) return {bezier_patches(*s, domain)};
    if (const auto s = as<Geom_BSplineSurface>(surface)) return {spline_patches(*s, domain)};
    return approximation(surface, domain);
}

} // namespace

SurfaceHandle untrimmed(SurfaceHandle surface) {
    while (const auto trimmed = as<Geom_RectangularTrimmedSurface>(surface))
        surface = trimmed->BasisSurface();
    return surface;
}

Vec2 periods(const Geom_Surface& surface) {
    return {surface.IsUPeriodic() ? surface.UPeriod() : 0,
            surface.IsVPeriodic() ? surface.VPeriod() : 0};
}

Box2 natural_domain(const Geom_Surface& surface) {
    const auto finite = [](double x) {
        return Precision::IsInfinite(x) ? std::copysign(Box2::infinity, x) : x;
    };
    double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
    surface.Bounds(u1, u2, v1, v2);
    return {{finite(u1), finite(v1)}, {finite(u2), finite(v2)}};
}

SurfacePatches surface_patches(const SurfaceHandle& trimmed, const Box2& domain) {
    const SurfaceHandle surface = untrimmed(trimmed);
    const Vec2 extent = domain.extent();
    if (!std::isfinite(extent.x) || !std::isfinite(extent.y))
        throw Error("", "", "an infinite " + surface_kind(surface) + " without bounds");
    if (!(extent.x > 0) || !(extent.y > 0)) throw Error("", "", "its parameter domain is empty");
    return convert(surface, domain);
}

std::string surface_kind(const SurfaceHandle& trimmed) {
    const SurfaceHandle surface = untrimmed(trimmed);
    if (as<Geom_Plane>(surface)) return "plane";
    if (as<Geom_CylindricalSurface>(surface)) return "cylinder";
    if (as<Geom_ConicalSurface>(surface)) return "cone";
    if (as<Geom_SphericalSurface>(surface)) return "sphere";
    if (as<Geom_ToroidalSurface>(surface)) return "torus";
    if (as<Geom_SurfaceOfRevolution>(surface)) return "revolution";
    if (as<Geom_SurfaceOfLinearExtrusion>(surface)) return "extrusion";
    if (as<Geom_BezierSurface>(surface)) return "bezier";
    if (as<Geom_BSplineSurface>(surface)) return "b-spline";
    if (as<Geom_OffsetSurface>(surface)) return "offset";
    return "procedural";
}

} // namespace keiko::cad
