#include "keiko/geometry/trim/material_bounds.h"

#include "keiko/base/error.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/trim/trim_region.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder;
using test::Random;
using test::uniform;
using Curve = std::vector<Vec3>;
using Loop = std::vector<Curve>;

void expect_box(const Box3& found, const Box3& expected, double tolerance) {
    for (unsigned k = 0; k < 3; ++k) {
        EXPECT_NEAR(found.lower[k], expected.lower[k], tolerance) << "lower, axis " << k;
        EXPECT_NEAR(found.upper[k], expected.upper[k], tolerance) << "upper, axis " << k;
    }
}

/// The box of what reaches so far from the centre along each axis.
Box3 around(const Vec3& center, const Vec3& reach) {
    return {center - reach, center + reach};
}

/// A circle of `quarters` rational arcs, counter-clockwise, begun at the angle `turn`.
Loop circle(const Vec2& center, double radius, double turn, int quarters = 4) {
    Loop loop;
    const double quarter = std::numbers::pi / 2, w = std::sqrt(0.5);
    for (int q = 0; q < quarters; ++q) {
        const double a = turn + q * quarter, b = a + quarter;
        const Vec2 from(std::cos(a), std::sin(a)), to(std::cos(b), std::sin(b));
        const Vec2 p = center + from * radius, m = center + (from + to) * radius;
        const Vec2 r = center + to * radius;
        loop.push_back({Vec3(p.x, p.y, 1), Vec3(m.x, m.y, 1) * w, Vec3(r.x, r.y, 1)});
    }
    return loop;
}

Curve line(const Vec2& a, const Vec2& b) {
    return {Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)};
}

/// z = height - bend ((x - 1/2)^2 + (y - 1/2)^2) over the unit square.
ModelBuilder dome(double height, double bend) {
    ModelBuilder builder;
    std::vector<Vec3> points;
    const double square[3] = {0.25, -0.25, 0.25}; // (t - 1/2)^2 in Bernstein form
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            points.emplace_back(i / 2.0, j / 2.0, height - bend * (square[i] + square[j]));
    builder.patch(2, 2, points);
    return builder;
}

TEST(MaterialBounds, AreThoseOfASphereHoweverItIsPlaced) {
    const Vec3 center(1000, -2000, 300);
    for (const double turn : {0.0, 0.3, 1.1}) {
        const Affine placed =
            Affine::translate(center) * Affine::rotate({1, 2, 3}, turn) * Affine::scale(50);
        expect_box(material_bounds(test::sphere_model(placed)), around(center, Vec3(50)), 5e-7);
    }
}

TEST(MaterialBounds, AreThoseOfACylinderInAnyDirection) {
    Random random(1);
    for (int i = 0; i < 10; ++i) {
        const Vec3 axis = test::random_direction(random), center(3, 4, 5);
        Affine placed = test::stretched({2, 2, 7}, axis, center);
        if (i % 2)
            for (Vec3& row : placed.rows) row.x = -row.x; // a mirror image
        Vec3 reach;
        for (unsigned k = 0; k < 3; ++k)
            reach[k] = 2 * std::sqrt(1 - axis[k] * axis[k]) + 7 * std::abs(axis[k]);
        expect_box(material_bounds(test::cylinder_model(placed)), around(center, reach), 1e-7);
    }
}

TEST(MaterialBounds, AreThoseOfATurnedTorus) {
    SurfaceModel model = test::torus_model(10, 3, 0.2);
    const Affine turned = Affine::rotate({1, 1, 0.3}, 0.7);
    model.instances[0].transform = turned;
    const Vec3 axis = turned.vector({0, 0, 1});
    Vec3 reach;
    for (unsigned k = 0; k < 3; ++k) reach[k] = 10 * std::sqrt(1 - axis[k] * axis[k]) + 3;
    expect_box(material_bounds(model), around(Vec3(0), reach), 3e-7);
}

TEST(MaterialBounds, HoldEveryInstanceAndNotTheBoxOfABox) {
    ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(4, 0, 0), Vec3(0, 2, 0));
    builder.loop(circle({0.5, 0.5}, 0.25, 0.1)); // an ellipse of radii 1 and 1/2
    builder.instance(Affine::translate({10, 0, 0}));
    builder.instance(Affine::rotate({0, 0, 1}, std::numbers::pi / 4));
    const double diagonal = std::sqrt((1 + 0.25) / 2), c = std::sqrt(0.5);
    const Vec2 turned(2 * c - c, 2 * c + c); // of the middle (2, 1)
    const Box3 box = material_bounds(builder.build());
    expect_box(box, {{turned.x - diagonal, 0.5, 0}, {13, turned.y + diagonal, 0}}, 1e-8);
}

TEST(MaterialBounds, LeaveOutAPeakThatIsTrimmedAway) {
    ModelBuilder builder = dome(10, 4);
    builder.loop(circle({0.5, 0.5}, 0.4, 0.3));
    builder.loop(circle({0.55, 0.45}, 0.2, 0.7));
    const double nearest = 0.2 - std::hypot(0.05, 0.05); // of the hole's rim to the peak
    const Box3 box = material_bounds(builder.build());
    expect_box(box, {{0.1, 0.1, 10 - 4 * 0.16}, {0.9, 0.9, 10 - 4 * nearest * nearest}}, 2e-8);
}

TEST(MaterialBounds, FindThePeakAndTheSaddleInsideATrim) {
    ModelBuilder builder = dome(10, 4);
    builder.loop(circle({0.6, 0.5}, 0.2, 0.3));
    EXPECT_NEAR(material_bounds(builder.build()).upper.z, 10, 1e-8);

    // z = (2x - 1)(2y - 1): extreme only on the rim, where |x - 1/2| = |y - 1/2|.
    ModelBuilder saddle;
    saddle.patch(1, 1, {{0, 0, 1}, {0, 1, -1}, {1, 0, -1}, {1, 1, 1}});
    saddle.loop(circle({0.5, 0.5}, 0.3, 0.2));
    const double reach = 2 * 0.3 * 0.3;
    expect_box(material_bounds(saddle.build()), {{0.2, 0.2, -reach}, {0.8, 0.8, reach}}, 2e-8);
}

TEST(MaterialBounds, FollowATrimAcrossThePatchesOfAFace) {
    // Bowl z = x^2 + y^2 over [-1, 1]^2 in 4 x 4 patches, cut by a circle about (0.2, -0.1).
    ModelBuilder builder;
    NurbsSurface bowl{2, 2, {}, {}, {}};
    constexpr int spans = 4;
    std::vector<double> knots{-1, -1, -1, -0.5, 0, 0.5, 1, 1, 1};
    bowl.knots_u = bowl.knots_v = knots;
    for (int i = 0; i < spans + 2; ++i)
        for (int j = 0; j < spans + 2; ++j) {
            // Blossoms of t and t^2 at neighbouring knots.
            const auto at = [&](int k) { return knots[static_cast<std::size_t>(k)]; };
            bowl.points.emplace_back((at(i + 1) + at(i + 2)) / 2, (at(j + 1) + at(j + 2)) / 2,
                                     at(i + 1) * at(i + 2) + at(j + 1) * at(j + 2), 1);
        }
    builder.nurbs(bowl);
    const double far = std::hypot(0.2, 0.1);
    builder.loop(circle({0.2, -0.1}, 0.6, 0.4));
    expect_box(material_bounds(builder.build()),
               {{-0.4, -0.7, 0}, {0.8, 0.5, (0.6 + far) * (0.6 + far)}}, 3e-8);
    builder.loop(circle({0.2, -0.1}, 0.5, 0.4));
    EXPECT_NEAR(material_bounds(builder.build()).lower.z, (0.5 - far) * (0.5 - far), 3e-8);
}

TEST(MaterialBounds, AreExactWhereTheMaterialIsFlat) {
    ModelBuilder builder;
    builder.plane(Vec3(-3, 1, 7), Vec3(10, 0, 0), Vec3(0, 20, 0));
    builder.polygon({{0.1, 0.2}, {0.7, 0.2}, {0.7, 0.95}, {0.1, 0.95}});
    const Box3 box = material_bounds(builder.build());
    EXPECT_EQ(box.lower.z, 7);
    EXPECT_EQ(box.upper.z, 7);
    expect_box(box, {{-2, 5, 7}, {4, 20, 7}}, 1e-13);
}

TEST(MaterialBounds, AreEmptyWithoutMaterial) {
    EXPECT_TRUE(material_bounds({}).empty());
    ModelBuilder nothing = dome(1, 1);
    nothing.loop({line({0.1, 0.1}, {0.9, 0.5}), line({0.9, 0.5}, {0.1, 0.1})});
    EXPECT_TRUE(material_bounds(nothing.build()).empty());
}

TEST(MaterialBounds, LeaveOutATrimThatGoesForthAndBack) {
    ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    builder.polygon({{0.1, 0.1}, {0.5, 0.1}, {0.9, 0.3}, {0.5, 0.1}, {0.5, 0.4}, {0.1, 0.4}});
    expect_box(material_bounds(builder.build()), {{0.1, 0.1, 0}, {0.5, 0.4, 0}}, 1e-14);
}

TEST(MaterialBounds, HoldSamplesOfWildTrimsAndNotMuchMore) {
    Random random(7);
    for (int round = 0; round < 20; ++round) {
        ModelBuilder builder;
        std::vector<Vec4> points;
        for (int i = 0; i <= 3; ++i)
            for (int j = 0; j <= 3; ++j) {
                const double w = round % 2 ? uniform(random, 0.5, 2) : 1;
                points.emplace_back(w * uniform(random, -3, 3), w * uniform(random, -3, 3),
                                    w * uniform(random, -3, 3), w);
            }
        builder.rational_patch(3, 3, points);
        std::vector<Vec2> knots;
        for (int k = 0; k < 5; ++k)
            knots.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1));
        Loop loop;
        for (std::size_t k = 0; k < knots.size(); ++k) {
            const Vec2 &a = knots[k], &b = knots[(k + 1) % knots.size()];
            loop.push_back({Vec3(a.x, a.y, 1),
                            Vec3(uniform(random, 0, 1), uniform(random, 0, 1), 1),
                            Vec3(b.x, b.y, 1)});
        }
        builder.loop(loop);
        const SurfaceModel model = builder.build();
        const Box3 box = material_bounds(model);

        Box3 samples;
        const TrimRegion trims(model, model.faces[0]);
        constexpr int cells = 300, steps = 3000;
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; j <= cells; ++j) {
                const Vec2 uv(double(i) / cells, double(j) / cells);
                if (trims.contains(uv)) samples.extend(evaluate(model.patch(0), uv, 0).position());
            }
        const BoundaryCurves borders(model);
        for (const BoundaryInterval& border : borders.all())
            for (int k = 0; k <= steps; ++k)
                samples.extend(borders.curve(border).at(double(k) / steps).position);
        EXPECT_TRUE(box.padded(1e-12).contains(samples.lower)) << round;
        EXPECT_TRUE(box.padded(1e-12).contains(samples.upper)) << round;
        // Samples are no farther from the top than a cell, where the surface bends by so much.
        const double sampling = 50.0 / cells / cells;
        expect_box(box, samples, sampling);
    }
}

TEST(MaterialBounds, AreTheSameForAnyNumberOfThreadsAndCanBeCancelled) {
    SurfaceModel model = test::torus_model(10, 3, 0.2);
    model.instances[0].transform = Affine::rotate({1, 1, 0.3}, 0.7);
    EXPECT_EQ(material_bounds(model, {.threads = 1}), material_bounds(model, {.threads = 3}));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(material_bounds(model, {.stop = stop.get_token()}), Cancelled);
}

} // namespace
} // namespace keiko
