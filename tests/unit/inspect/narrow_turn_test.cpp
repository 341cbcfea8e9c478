// Hairpins inside a patch, found by their normals, against samples about the place of least speed.
#include "keiko/inspect/regularity/narrow_turn.h"

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/analytic_models.h"
#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double negligible = 0.1;

/// A bicubic sheet of `size` mm whose control point (1, 1) is moved across the others, so that it
/// nearly folds there.
SurfaceModel nearly_folded(double size, const Vec3& moved) {
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            points.push_back(i == 1 && j == 1 ? moved : Vec3(size * i / 3, size * j / 3, 0));
    builder.patch(3, 3, points);
    return builder.build();
}

struct Sample {
    Vec3 position, normal;
    double speed = 0; ///< |S_u x S_v|
};

/// Samples of the first patch on a grid of `steps` in a box, kept in the patch.
std::vector<Sample> samples(const SurfaceModel& model, const Vec2& middle, double half, int steps) {
    std::vector<Sample> all;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const Vec2 off = Vec2(i, j) * (2 * half / steps) - Vec2(half, half);
            const Vec2 uv{std::clamp(middle.x + off.x, 0.0, 1.0),
                          std::clamp(middle.y + off.y, 0.0, 1.0)};
            const SurfaceDerivatives s = evaluate(model.patch(0), uv, 1);
            const Vec3 n = s.du().cross(s.dv());
            all.push_back({s.position(), n.normalized(), n.length()});
        }
    return all;
}

/// The place of least speed, by ever smaller grids.
Vec2 slowest(const SurfaceModel& model) {
    Vec2 middle(0.5, 0.5);
    constexpr int steps = 40;
    for (double half = 0.5; half > 1e-6; half /= 4) {
        const auto all = samples(model, middle, half, steps);
        const auto least =
            std::min_element(all.begin(), all.end(),
                             [](const Sample& a, const Sample& b) { return a.speed < b.speed; });
        const auto index = static_cast<int>(least - all.begin());
        const Vec2 share(index / (steps + 1), index % (steps + 1));
        middle += share * (2 * half / steps) - Vec2(half, half);
        middle = {std::clamp(middle.x, 0.0, 1.0), std::clamp(middle.y, 0.0, 1.0)};
    }
    return middle;
}

/// Radius of the smallest arc between two samples about the slowest place, mm.
double sampled_radius(const SurfaceModel& model) {
    double least = HUGE_VAL;
    const Vec2 middle = slowest(model);
    for (double half = 0.1; half > 1e-5; half /= 2) {
        const auto all = samples(model, middle, half, 12);
        for (const Sample& a : all)
            for (const Sample& b : all) {
                const double way = (a.position - b.position).length();
                const double turn = angle_between(a.normal, b.normal);
                if (way < negligible && turn > 1)
                    least = std::min(least, way / (2 * std::sin(turn / 2)));
            }
    }
    return least;
}

TEST(NarrowTurn, IsFoundWhereverSamplesHaveOne) {
    test::Random random(1);
    int narrow = 0, not_by_curvature = 0;
    for (int i = 0; i < 80; ++i) {
        const double size = test::uniform(random, 5, 200);
        const double back = -size * test::uniform(random, 0.2, 0.6);
        const double high = std::pow(10, test::uniform(random, -3, 1));
        const SurfaceModel model = nearly_folded(size, {back, back, high});
        if (!(sampled_radius(model) < negligible / 2)) continue;
        ++narrow;
        const auto found = narrow_turn(model, 0, 0, negligible);
        ASSERT_TRUE(found) << size << " " << back << " " << high;
        EXPECT_LT(found->radius, negligible);
        const auto curvature = face_curvature(model, 0, 0);
        ASSERT_TRUE(curvature);
        if (std::max(curvature->largest.value, -curvature->smallest.value) * negligible < 1)
            ++not_by_curvature;
        const Inspection inspection = inspect(model);
        EXPECT_FALSE(inspection.looks.empty() && inspection.findings.empty());
        EXPECT_LT(inspection.faces[0].radius->value, negligible);
    }
    EXPECT_GT(narrow, 10);
    EXPECT_GT(not_by_curvature, 3);
}

TEST(NarrowTurn, IsNoneOnEvenlyBentFaces) {
    for (const double radius : {0.11, 0.5, 50.0})
        EXPECT_FALSE(narrow_turn(
            test::cylinder_model(test::stretched({radius, radius, 20}, {0, 0, 1}, {500, 0, 0})), 0,
            0, negligible));
}

TEST(NarrowTurn, IsTheRadiusOfANarrowCylinder) {
    const auto found =
        narrow_turn(test::cylinder_model(test::stretched({0.05, 0.05, 20}, {0, 0, 1}, {500, 0, 0})),
                    0, 0, negligible);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->radius, 0.05, 1e-6);
}

} // namespace
} // namespace keiko
