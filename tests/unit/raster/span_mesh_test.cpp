#include "keiko/raster/span_mesh.h"

#include "keiko/raster/second_derivative_bounds.h"

#include "tests/support/analytic_models.h"
#include "tests/support/model_builder.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <utility>

namespace keiko {
namespace {

/// The largest distance of the patch from the plane triangles between its places at the corners of
/// cells, at random places of these.
double sampled_deviation(const BezierPatchView& patch, const SpanCells& cells) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    double most = 0;
    for (int i = 0; i < cells.u; ++i)
        for (int j = 0; j < cells.v; ++j)
            for (int k = 0; k < 40; ++k) {
                double s = share(random), t = share(random);
                if (t > s) std::swap(s, t);
                const auto at = [&](double x, double y) {
                    return evaluate(patch, Vec2((i + x) / cells.u, (j + y) / cells.v), 0)
                        .position();
                };
                const Vec3 flat = at(0, 0) + (at(1, 0) - at(0, 0)) * s + (at(1, 1) - at(1, 0)) * t;
                most = std::max(most, (at(s, t) - flat).length());
            }
    return most;
}

TEST(SpanMesh, BoundsTheDeviationOfEachPatch) {
    for (const SurfaceModel& model :
         {test::sphere_model(test::stretched(Vec3(100, 50, 30), Vec3(1, 2, 3), Vec3(5, 5, 5))),
          test::torus_model(100, 20), test::bonnet_model(1000, 800, 60)})
        for (std::uint32_t p = 0; p < model.patches.size(); ++p) {
            const auto bounds = SecondDerivativeBounds::of(model.patch(p));
            for (const double asked : {1.0, 0.05}) {
                const SpanCells cells = bounds.cells_within(asked, most_span_triangles);
                EXPECT_LE(bounds.deviation(cells), asked);
                const double found = sampled_deviation(model.patch(p), cells);
                EXPECT_LE(found, bounds.deviation(cells));
                EXPECT_GT(found, bounds.deviation(cells) / 20);
            }
        }
}

/// z = height u^2 over a square, one patch.
SurfaceModel parabola(double height) {
    test::ModelBuilder builder;
    builder.patch(2, 1,
                  {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0.5, 0, 0), Vec3(0.5, 1, 0),
                   Vec3(1, 0, height), Vec3(1, 1, height)});
    builder.instance({});
    return builder.build();
}

TEST(SpanMesh, BoundOfAParabolaIsMet) {
    const SurfaceModel model = parabola(1);
    const auto bounds = SecondDerivativeBounds::of(model.patch(0));
    EXPECT_NEAR(bounds.deviation({1, 1}), 0.25, 1e-12); // at u = 1/2, from the chord
    EXPECT_NEAR(bounds.deviation({4, 1}), 0.25 / 16, 1e-12);
}

TEST(SpanMesh, MeetsTheDeviationOrRefuses) {
    for (const double asked : {1e-2, 1e-6}) { // some 500 cells and 50000
        const ModelMesh mesh = span_mesh(parabola(1e4), asked);
        EXPECT_GT(mesh.front().triangles.size(), 100U);
        EXPECT_LE(mesh.front().deviation, asked);
    }
    EXPECT_THROW(span_mesh(parabola(1e4), 1e-6, {}, {40000}), Error);
    EXPECT_THROW(span_mesh(parabola(1e4), 1e-13), Error);
    EXPECT_THROW(span_mesh(parabola(1e200), 1), Error); // the bound is beyond all numbers
}

double area(const FaceMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += (mesh.uv[b] - mesh.uv[a]).cross(mesh.uv[c] - mesh.uv[a]) / 2;
    return sum;
}

TEST(SpanMesh, CutsCellsAlongTrimCurves) {
    test::ShapeBuilder shape; // a plate of 10 x 10 with a hole
    shape.face({test::rectangle(0, 10, 0, 10, 0)},
               {test::polygon({Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(0, 10)}),
                test::circle(Vec2(4, 5), 2.5)});
    const double exact = 100 - std::numbers::pi * 2.5 * 2.5;
    const FaceMesh coarse = span_mesh(shape.model(), 0.1).front();
    const FaceMesh fine = span_mesh(shape.model(), 0.005).front();
    EXPECT_NEAR(area(coarse), exact, 2 * std::numbers::pi * 2.5 * 0.1);
    EXPECT_NEAR(area(fine), exact, 2 * std::numbers::pi * 2.5 * 0.005);
    for (const auto& [a, b, c] : fine.triangles)
        EXPECT_GE((fine.uv[b] - fine.uv[a]).cross(fine.uv[c] - fine.uv[a]), 0);
}

/// A square plate with a round hole.
FaceMesh holed_plate(double side, const Vec2& centre, double radius, double deviation) {
    test::ShapeBuilder shape;
    shape.face({test::rectangle(0, side, 0, side, 0)},
               {test::polygon({Vec2(0, 0), Vec2(side, 0), Vec2(side, side), Vec2(0, side)}),
                test::circle(centre, radius)});
    return span_mesh(shape.model(), deviation).front();
}

TEST(SpanMesh, KeepsSmallHolesOfLargePlates) {
    constexpr double side = 1000, radius = 5, around = 2 * std::numbers::pi * radius;
    const double exact = side * side - std::numbers::pi * radius * radius;
    for (const Vec2& centre : {Vec2(500, 500), Vec2(317.3, 621.7), Vec2(250, 8)})
        for (const double deviation : {0.1, 0.004}) {
            const FaceMesh mesh = holed_plate(side, centre, radius, deviation);
            EXPECT_NEAR(area(mesh), exact, around * deviation);
            EXPECT_LE(mesh.deviation, deviation);
            EXPECT_GT(mesh.deviation, deviation / 100); // it tells of the trims: the plate is flat
            EXPECT_LT(mesh.triangles.size(), 2000U);
            for (const auto& [a, b, c] : mesh.triangles) {
                const Vec2 middle = (mesh.uv[a] + mesh.uv[b] + mesh.uv[c]) / 3;
                EXPECT_GT((middle - centre).length(), radius - deviation);
            }
        }
}

TEST(SpanMesh, KeepsTheCornersOfSmallCutOuts) {
    // A slot of 4 x 2 whose sides partly run along those of cells.
    test::ShapeBuilder shape;
    const Vec2 low(500, 499), high(504, 501);
    shape.face({test::rectangle(0, 1000, 0, 1000, 0)},
               {test::polygon({Vec2(0, 0), Vec2(1000, 0), Vec2(1000, 1000), Vec2(0, 1000)}),
                test::polygon({low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)})});
    const FaceMesh mesh = span_mesh(shape.model(), 0.05).front();
    EXPECT_NEAR(area(mesh), 1e6 - 8, 12 * 0.05);
    EXPECT_LT(mesh.triangles.size(), 1000U);
}

TEST(SpanMesh, CutsCurvedFacesOfAngularParameters) {
    constexpr double radius = 20, height = 100, around = 2 * std::numbers::pi, hole = 0.5;
    test::ShapeBuilder shape; // a hole of 20 x 1 mm in a cylinder, an ellipse when it is unrolled
    shape.face(test::cylinder(radius, height),
               {test::polygon({Vec2(0, 0), Vec2(around, 0), Vec2(around, height), Vec2(0, height)}),
                test::circle(Vec2(1.5, 40.3), hole)});
    const double exact = around * height - std::numbers::pi * hole * hole;
    for (const double deviation : {0.1, 0.005}) {
        const FaceMesh mesh = span_mesh(shape.model(), deviation).front();
        constexpr double border = 41; // mm, above the ellipse's 40.1
        EXPECT_NEAR(radius * area(mesh), radius * exact, border * deviation);
        EXPECT_LE(mesh.deviation, deviation);
    }
}

TEST(SpanMesh, RefusesMoreCellsOrTrianglesThanAllowed) {
    const SurfaceModel torus = test::torus_model(100, 20);
    const std::size_t count = span_mesh(torus, 0.05).front().triangles.size();
    EXPECT_EQ(span_mesh(torus, 0.05, {}, {count}).front().triangles.size(), count);
    EXPECT_THROW(span_mesh(torus, 0.05, {}, {count - 1}), Error);
    EXPECT_THROW(span_mesh(torus, 0.05, {}, {2 * count, count + 1}), Error);
    test::ShapeBuilder shape; // one cell, but many triangles along the hole
    shape.face({test::rectangle(0, 9, 0, 9, 0)},
               {test::polygon({Vec2(0, 0), Vec2(9, 0), Vec2(9, 9), Vec2(0, 9)}),
                test::circle(Vec2(4, 4), 2)});
    EXPECT_GT(span_mesh(shape.model(), 1e-3).front().triangles.size(), 20U);
    try {
        span_mesh(shape.model(), 1e-3, {}, {20});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "its mesh within 0.001 mm has more than 20 cells or triangles");
    }
}

TEST(SpanMesh, NeighboursHaveAsManyCellsAlongTheirCommonSide) {
    const SurfaceModel model = test::torus_model(100, 20);
    const FaceMesh mesh = span_mesh(model, 0.05).front();
    EXPECT_LE(mesh.deviation, 0.05);
    std::set<double> rows;
    for (const Vec2& uv : mesh.uv) rows.insert(uv.y);
    // Every row of cells runs through all patches.
    EXPECT_EQ(mesh.triangles.size() % (2 * (rows.size() - 1)), 0U);
}

} // namespace
} // namespace keiko
