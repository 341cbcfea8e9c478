#include "keiko/geometry/bezier/nurbs.h"
#include "keiko/import/cad/curve_spans.h"
#include "keiko/import/cad/surface_patches.h"

namespace keiko::cad {

namespace {

/// Homogeneous image of a homogeneous profile point turned by a homogeneous point of the unit
/// circle: the part along the axis stays, the part across it turns.
Vec4 turned(const Axis& axis, const Vec4& point, const Vec3& circle) {
    const Vec3 from_origin = Vec3(point.x, point.y, point.z) - axis.origin * point.w;
    const Vec3 along = axis.direction * from_origin.dot(axis.direction);
    const Vec3 across = from_origin - along;
    const Vec3 quarter_turn = axis.direction.cross(across) * (axis.left_handed ? -1.0 : 1.0);
    const Vec3 p =
        (axis.origin * point.w + along) * circle.z + across * circle.x + quarter_turn * circle.y;
    return {p.x, p.y, p.z, point.w * circle.z};
}

Vec4 shifted(const Vec4& point, const Vec3& offset) {
    return {point.x + offset.x * point.w, point.y + offset.y * point.w,
            point.z + offset.z * point.w, point.w};
}

} // namespace

std::vector<SurfacePatch> revolved(const Axis& axis, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile) {
    std::vector<SurfacePatch> patches;
    for (const UnitArc& arc : circle_arcs(begin, end))
        for (const CurveSpan<Vec4>& span : profile) {
            SurfacePatch patch{arc.map, span.map, 2, static_cast<int>(span.points.size()) - 1, {}};
            for (const Vec3& circle : arc.points)
                for (const Vec4& point : span.points)
                    patch.points.push_back(turned(axis, point, circle));
            patches.push_back(std::move(patch));
        }
    return patches;
}

std::vector<SurfacePatch> extruded(const Vec3& direction, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile) {
    const ParameterMap map_v{ParameterMap::Kind::affine, begin, end};
    std::vector<SurfacePatch> patches;
    for (const CurveSpan<Vec4>& span : profile) {
        SurfacePatch patch{span.map, map_v, static_cast<int>(span.points.size()) - 1, 1, {}};
        for (const Vec4& point : span.points) {
            patch.points.push_back(shifted(point, direction * begin));
            patch.points.push_back(shifted(point, direction * end));
        }
        patches.push_back(std::move(patch));
    }
    return patches;
}

namespace {

Vec4 homogeneous(const gp_Pnt& p, double w) {
    return {p.X() * w, p.Y() * w, p.Z() * w, w};
}

/// How much of its domain a face must reach into a knot span for the span to count: p-curves
/// that lie on a knot stray over it by rounding.
constexpr double least_overlap = 1e-9;

/// OpenCASCADE leaves garbage for weights in a polynomial surface that was periodic.
double weight(const auto& s, int i, int j) {
    return s.IsURational() || s.IsVRational() ? s.Weight(i, j) : 1;
}

NurbsSurface nurbs_surface(const Geom_BSplineSurface& s) {
    NurbsSurface result{s.UDegree(),
                        s.VDegree(),
                        flat_knots(s.UKnots(), s.UMultiplicities()),
                        flat_knots(s.VKnots(), s.VMultiplicities()),
                        {}};
    for (int i = 1; i <= s.NbUPoles(); ++i)
        for (int j = 1; j <= s.NbVPoles(); ++j)
            result.points.push_back(homogeneous(s.Pole(i, j), weight(s, i, j)));
    return result;
}

opencascade::handle<Geom_BSplineSurface> not_periodic(const Geom_BSplineSurface& s) {
    auto copy = opencascade::handle<Geom_BSplineSurface>::DownCast(s.Copy());
    if (copy->IsUPeriodic()) copy->SetUNotPeriodic();
    if (copy->IsVPeriodic()) copy->SetVNotPeriodic();
    return copy;
}

bool overlaps(double begin, double end, double from, double to, double range) {
    return std::min(end, to) - std::max(begin, from) > least_overlap * range;
}

/// Continues a patch along u to the parameters begin..end, as its polynomials run.
void continue_u(SurfacePatch& patch, double begin, double end) {
    if (begin == patch.map_u.begin && end == patch.map_u.end) return;
    const double a = patch.map_u.to_patch(begin), b = patch.map_u.to_patch(end);
    const auto width = static_cast<std::size_t>(patch.degree_v) + 1;
    const auto height = static_cast<std::size_t>(patch.degree_u) + 1;
    for (std::size_t j = 0; j < width; ++j) {
        std::vector<Vec4> column;
        for (std::size_t i = 0; i < height; ++i) column.push_back(patch.points[i * width + j]);
        column = bezier_segment(column, a, b);
        for (std::size_t i = 0; i < height; ++i) patch.points[i * width + j] = column[i];
    }
    patch.map_u = {ParameterMap::Kind::affine, begin, end};
}

void continue_v(SurfacePatch& patch, double begin, double end) {
    if (begin == patch.map_v.begin && end == patch.map_v.end) return;
    const double a = patch.map_v.to_patch(begin), b = patch.map_v.to_patch(end);
    const auto width = static_cast<std::ptrdiff_t>(patch.degree_v) + 1;
    for (auto row = patch.points.begin(); row != patch.points.end(); row += width) {
        const std::vector<Vec4> segment = bezier_segment(std::vector<Vec4>(row, row + width), a, b);
        std::copy(segment.begin(), segment.end(), row);
    }
    patch.map_v = {ParameterMap::Kind::affine, begin, end};
}

/// Continues the patches at the border of the surface as far as the domain goes beyond it.
void continue_to(std::vector<SurfacePatch>& patches, const Box2& domain, const Box2& natural,
                 const Vec2& period) {
    for (SurfacePatch& p : patches) {
        const ParameterMap u = p.map_u, v = p.map_v;
        const auto low = [](double begin, double border, double wanted, double repeats) {
            return repeats == 0 && begin == border ? std::min(begin, wanted) : begin;
        };
        const auto high = [](double end, double border, double wanted, double repeats) {
            return repeats == 0 && end == border ? std::max(end, wanted) : end;
        };
        continue_u(p, low(u.begin, natural.lower.x, domain.lower.x, period.x),
                   high(u.end, natural.upper.x, domain.upper.x, period.x));
        continue_v(p, low(v.begin, natural.lower.y, domain.lower.y, period.y),
                   high(v.end, natural.upper.y, domain.upper.y, period.y));
    }
}

} // namespace

std::vector<SurfacePatch> spline_patches(const Geom_BSplineSurface& surface, const Box2& domain) {
    const Vec2 period = periods(surface);
    const NurbsSurface nurbs = nurbs_surface(*not_periodic(surface));
    const Vec2 extent = domain.extent();
    std::vector<SurfacePatch> patches;
    for (BezierPatchSpan& span : bezier_spans(nurbs)) {
        const PeriodRange turns_u(span.u_begin, span.u_end, domain.lower.x, domain.upper.x,
                                  period.x);
        const PeriodRange turns_v(span.v_begin, span.v_end, domain.lower.y, domain.upper.y,
                                  period.y);
        for (int i = turns_u.first; i <= turns_u.last; ++i)
            for (int j = turns_v.first; j <= turns_v.last; ++j) {
                const double du = i * period.x, dv = j * period.y;
                const ParameterMap u{ParameterMap::Kind::affine, span.u_begin + du,
                                     span.u_end + du};
                const ParameterMap v{ParameterMap::Kind::affine, span.v_begin + dv,
                                     span.v_end + dv};
                if (overlaps(u.begin, u.end, domain.lower.x, domain.upper.x, extent.x) &&
                    overlaps(v.begin, v.end, domain.lower.y, domain.upper.y, extent.y))
                    patches.push_back({u, v, nurbs.degree_u, nurbs.degree_v, span.points});
            }
    }
    continue_to(patches, domain, natural_domain(surface), period);
    return patches;
}

std::vector<SurfacePatch> bezier_patches(const Geom_BezierSurface& s, const Box2& domain) {
    SurfacePatch patch{{}, {}, s.UDegree(), s.VDegree(), {}};
    for (int i = 1; i <= s.NbUPoles(); ++i)
        for (int j = 1; j <= s.NbVPoles(); ++j)
            patch.points.push_back(homogeneous(s.Pole(i, j), weight(s, i, j)));
    std::vector<SurfacePatch> patches{std::move(patch)};
    continue_to(patches, domain, natural_domain(s), {0, 0});
    return patches;
}

} // namespace keiko::cad
