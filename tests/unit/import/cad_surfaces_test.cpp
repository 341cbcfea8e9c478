#include "keiko/base/error.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/cad/surface_patches.h"
#include "keiko/math/interval_set.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Hypr.hxx>
#include <gp_Parab.hxx>
#include <gtest/gtest.h>

#include <cmath>

namespace keiko::cad {
namespace {

using Surface = opencascade::handle<Geom_Surface>;

gp_Ax3 frame(bool left_handed) {
    gp_Ax3 ax(gp_Pnt(10, -20, 30), gp_Dir(1, 2, 3), gp_Dir(2, -1, 0.5));
    if (left_handed) ax.YReverse();
    return ax;
}

/// Largest distance of the patches from the surface, relative to its size, and of the domain they
/// cover from the requested one.
double deviation(const Surface& surface, const Box2& domain) {
    const SurfacePatches converted = surface_patches(surface, domain);
    double worst = 0, area = 0;
    Box2 covered;
    Box3 box;
    for (const SurfacePatch& p : converted.patches) {
        const BezierPatchView view{p.degree_u, p.degree_v, p.points};
        covered.extend(Vec2(p.map_u.begin, p.map_v.begin));
        covered.extend(Vec2(p.map_u.end, p.map_v.end));
        area += (p.map_u.end - p.map_u.begin) * (p.map_v.end - p.map_v.begin);
        for (int i = 0; i <= 10; ++i)
            for (int j = 0; j <= 10; ++j) {
                const gp_Pnt wanted =
                    surface->Value(p.map_u.to_face(i / 10.0), p.map_v.to_face(j / 10.0));
                const Vec3 got = evaluate(view, {i / 10.0, j / 10.0}, 0).position();
                box.extend(got);
                worst = std::max(worst, (got - Vec3(wanted.X(), wanted.Y(), wanted.Z())).length());
            }
    }
    EXPECT_EQ(covered, domain);
    EXPECT_NEAR(area, domain.extent().x * domain.extent().y, 1e-9 * area);
    return worst / box.size();
}

TEST(SurfacePatches, ElementarySurfacesAreExactInBothHands) {
    for (const bool left : {false, true}) {
        const gp_Ax3 ax = frame(left);
        EXPECT_LT(deviation(new Geom_Plane(ax), {{-3, 1}, {8, 5}}), 1e-14);
        EXPECT_LT(deviation(new Geom_CylindricalSurface(ax, 7), {{-1, -20}, {2, 30}}), 1e-14);
        EXPECT_LT(deviation(new Geom_ConicalSurface(ax, 0.3, 7), {{1, -5}, {9, 30}}), 1e-14);
        EXPECT_LT(deviation(new Geom_SphericalSurface(ax, 7), {{0, -1}, {2, M_PI / 2}}), 1e-14);
        EXPECT_LT(deviation(new Geom_ToroidalSurface(ax, 40, 15), {{2, -1}, {5, 3}}), 1e-14);
    }
}

TEST(SurfacePatches, WholePeriodsAreCovered) {
    const double turn = 2 * M_PI;
    EXPECT_LT(deviation(new Geom_CylindricalSurface(frame(false), 7), {{0, 0}, {turn + 4e-13, 5}}),
              1e-14);
    EXPECT_LT(
        deviation(new Geom_SphericalSurface(frame(false), 7), {{0, -M_PI / 2}, {turn, M_PI / 2}}),
        1e-14);
    EXPECT_LT(deviation(new Geom_ToroidalSurface(frame(false), 40, 15), {{0, 0}, {turn, turn}}),
              1e-14);
    EXPECT_EQ(surface_patches(new Geom_ToroidalSurface(frame(false), 40, 15),
                              {{0, 0}, {turn + 4e-13, turn}})
                  .patches.size(),
              16u);
}

opencascade::handle<Geom_BSplineCurve> spline_curve() {
    TColgp_Array1OfPnt poles(1, 5);
    for (int i = 1; i <= 5; ++i) poles(i) = gp_Pnt(5 + i, std::sin(i), 3 * i);
    TColStd_Array1OfReal knots(1, 3);
    TColStd_Array1OfInteger multiplicities(1, 3);
    knots(1) = 0, knots(2) = 1, knots(3) = 3;
    multiplicities(1) = 4, multiplicities(2) = 1, multiplicities(3) = 4;
    return new Geom_BSplineCurve(poles, knots, multiplicities, 3);
}

std::vector<std::pair<opencascade::handle<Geom_Curve>, ParameterInterval>> profiles() {
    const gp_Ax2 ax(gp_Pnt(20, 1, 2), gp_Dir(0, 1, 0.2), gp_Dir(1, 0, 0));
    return {{new Geom_Line(gp_Pnt(20, 1, 2), gp_Dir(1, 2, 3)), {-2, 5}},
            {new Geom_Circle(ax, 4), {0.5, 6}},
            {new Geom_Ellipse(ax, 4, 2), {-1, 4}},
            {new Geom_Parabola(gp_Parab(ax, 2)), {-2, 3}},
            {new Geom_Hyperbola(gp_Hypr(ax, 3, 2)), {-1, 1.5}},
            {spline_curve(), {0.25, 2.5}}};
}

TEST(SurfacePatches, SweptSurfacesAreExactForEveryProfile) {
    const gp_Ax1 axis(gp_Pnt(1, 2, 3), gp_Dir(0.1, 0.2, 1));
    for (const auto& [profile, range] : profiles()) {
        const Surface turned = new Geom_SurfaceOfRevolution(profile, axis);
        EXPECT_LT(deviation(turned, {{0.3, range.begin}, {5, range.end}}), 1e-13);
        const Surface drawn = new Geom_SurfaceOfLinearExtrusion(profile, gp_Dir(1, 1, 4));
        EXPECT_LT(deviation(drawn, {{range.begin, -3}, {range.end, 8}}), 1e-13);
    }
}

opencascade::handle<Geom_BSplineSurface> spline_surface(bool periodic) {
    constexpr int count = 6;
    TColgp_Array2OfPnt poles(1, count, 1, count);
    for (int i = 1; i <= count; ++i)
        for (int j = 1; j <= count; ++j)
            poles(i, j) = gp_Pnt(10 * std::cos(i * 2 * M_PI / count),
                                 10 * std::sin(i * 2 * M_PI / count), 4 * j + i % 2);
    const int spans_u = periodic ? count : count - 3;
    TColStd_Array1OfReal u(1, spans_u + 1), v(1, 4);
    TColStd_Array1OfInteger mu(1, spans_u + 1), mv(1, 4);
    for (int i = 1; i <= spans_u + 1; ++i) u(i) = i, mu(i) = 1;
    if (!periodic) mu(1) = mu(spans_u + 1) = 4;
    for (int i = 1; i <= 4; ++i) v(i) = i, mv(i) = i == 1 || i == 4 ? 4 : 1;
    return new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 3, periodic, false);
}

TEST(SurfacePatches, SplineSpansAreExactAndCutToTheDomain) {
    EXPECT_LT(deviation(spline_surface(false), {{1, 1}, {4, 4}}), 1e-14);
    EXPECT_EQ(surface_patches(spline_surface(false), {{1.2, 1.2}, {1.9, 2 + 1e-12}}).patches.size(),
              1u);
}

TEST(SurfacePatches, APeriodicSplineIsRepeated) {
    EXPECT_LT(deviation(spline_surface(true), {{1, 1}, {7, 4}}), 1e-14);
    EXPECT_LT(deviation(spline_surface(true), {{-4, 1}, {2, 4}}), 1e-14);
}

TEST(SurfacePatches, AnOpenSplineIsContinuedALittle) {
    EXPECT_LT(deviation(spline_surface(false), {{0.99, 1}, {4, 4.01}}), 1e-13);
}

TEST(SurfacePatches, TrimmedSurfacesKeepTheirParameters) {
    const Surface torus = new Geom_ToroidalSurface(frame(false), 40, 15);
    EXPECT_LT(
        deviation(new Geom_RectangularTrimmedSurface(torus, 1.0, 3.0, 2.0, 4.0), {{1, 2}, {3, 4}}),
        1e-14);
}

TEST(SurfacePatches, OffsetSurfacesAreApproximatedWithinTheStatedTolerance) {
    const Surface offset = new Geom_OffsetSurface(spline_surface(false), 1.5);
    const Box2 domain{{1.5, 1}, {4, 3.5}};
    const SurfacePatches converted = surface_patches(offset, domain);
    EXPECT_GT(converted.approximated, 0);
    EXPECT_LE(converted.approximated, 1e-4);
    EXPECT_LT(deviation(offset, domain) * 20, 2 * converted.approximated);
}

TEST(SurfacePatches, InfiniteDomainsAreRefused) {
    const Surface plane = new Geom_Plane(frame(false));
    EXPECT_THROW(surface_patches(plane, natural_domain(*plane)), Error);
    EXPECT_THROW(surface_patches(plane, {{0, 0}, {0, 1}}), Error);
}

} // namespace
} // namespace keiko::cad
