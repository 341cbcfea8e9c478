#include "tests/support/brute_force.h"
#include "tests/support/exact_hits.h"
#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// The patch (x(u), 10 v, height(u)) of Bernstein coefficients, 10 mm wide.
PatchData extruded(const std::vector<double>& x, const std::vector<double>& height) {
    PatchData patch{static_cast<int>(x.size()) - 1, 1, {}, {}, {}};
    for (std::size_t i = 0; i < x.size(); ++i)
        for (const double y : {0.0, 10.0}) patch.points.emplace_back(x[i], y, height[i], 1);
    return patch;
}

/// Bernstein coefficients of the Chebyshev polynomial T_n over [0, 1], from its binomial form
/// (-1)^(n-i) C(2n, 2i) / C(n, i).
std::vector<double> chebyshev(int n) {
    std::vector<double> c;
    for (int i = 0; i <= n; ++i) {
        double ratio = 1;
        for (int k = 1; k <= i; ++k) ratio *= (2.0 * (n - k) + 1) / (2.0 * k - 1);
        c.push_back((n - i) % 2 == 0 ? ratio : -ratio);
    }
    return c;
}

std::vector<double> evenly(int n, double length) {
    std::vector<double> x;
    for (int i = 0; i <= n; ++i) x.push_back(length * i / n);
    return x;
}

class Folds : public testing::TestWithParam<int> {};

/// T_n takes each height below 1 at n places, u = (1 + cos((acos(h) + 2 pi k) / n)) / 2: one ray
/// through the wave meets them all.
TEST_P(Folds, GiveEveryRootNearestFirst) {
    const int n = GetParam();
    const SurfaceModel model =
        ShapeBuilder().face({extruded(evenly(n, 100), chebyshev(n))}).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    const ExactPatch exact(model.patch(0));
    for (const double height : {-0.9, -0.3, 0.0, 0.123, 0.7, 0.99}) {
        const Ray ray = ray_through(Vec3(-50, 3, height), Vec3(1, 0, 0));
        for (const Tracer* each : {&tracer, &clipping}) {
            const std::vector<Hit> hits = each->all(ray);
            ASSERT_EQ(hits.size(), static_cast<std::size_t>(n)) << height;
            for (int k = 0; k < n; ++k) {
                const double turn = (std::acos(height) + 2 * std::numbers::pi * k) / n;
                const auto root = exact_root(exact, ray, Vec2((1 + std::cos(turn)) / 2, 0.3));
                ASSERT_TRUE(root && root->on_patch()) << height << ' ' << k;
                EXPECT_TRUE(among(hits, *root)) << height << ' ' << k;
            }
            for (std::size_t k = 1; k < hits.size(); ++k) EXPECT_LT(hits[k - 1].t, hits[k].t);
            EXPECT_EQ(each->nearest(ray)->t, hits.front().t);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Waves, Folds, testing::Values(3, 4, 6, 9, 12, 15));

/// A bowl cut by a level ray through its axis: in either parameter the roots lie evenly on both
/// sides, and no clip shrinks the box.
TEST(NonShrinkingClips, AreSplitUntilBothRootsAreFound) {
    PatchData bowl{2, 2, {}, {}, {}};
    const double square[] = {1, -1, 1}; // (2 t - 1)^2
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            bowl.points.emplace_back(10 * i - 10, 10 * j - 10, 5 * (square[i] + square[j]), 1);
    const SurfaceModel model = ShapeBuilder().face({bowl}).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (const double height : {4.0, 1.0, 1e-2, 1e-4, 1e-6, 1e-8})
        for (const double turn : {0.0, 0.25, 0.5, 0.7853981633974483, 1.5707963267948966, 2.0}) {
            const Vec3 direction(std::cos(turn), std::sin(turn), 0);
            const Ray ray = ray_through(Vec3(0, 0, height) - direction * 40, direction);
            const double radius = std::sqrt(20 * height); // z = (x^2 + y^2) / 20
            for (const Tracer* each : {&tracer, &clipping}) {
                const std::vector<Hit> hits = each->all(ray);
                ASSERT_EQ(hits.size(), 2u) << height << ' ' << turn;
                EXPECT_NEAR(hits[0].t, 40 - radius, hits[0].position_bound);
                EXPECT_NEAR(hits[1].t, 40 + radius, hits[1].position_bound);
                EXPECT_LT(hits[0].position_bound, 1e-10 / radius);
            }
        }
}

/// Boxes over a fold that the ray passes just outside of converge towards a root that is not there.
TEST(ConvergedBoxes, WithoutARootGiveNoHit) {
    const SurfaceModel model =
        ShapeBuilder().face({extruded({0, 20, 0}, {0, 10, 20})}).model(); // x <= 10
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (const double clear : {1e-3, 1e-6, 1e-9, 1e-11})
        for (const double tilt : {0.0, 0.3, -2.0}) {
            const Ray beside = ray_through(Vec3(10 + clear, 5 - tilt * 20, -10), Vec3(0, tilt, 1));
            const Ray inside = ray_through(Vec3(10 - clear, 5 - tilt * 20, -10), Vec3(0, tilt, 1));
            for (const Tracer* each : {&tracer, &clipping}) {
                EXPECT_TRUE(each->all(beside).empty()) << clear << ' ' << tilt;
                EXPECT_EQ(each->all(inside).size(), 2u) << clear << ' ' << tilt;
            }
        }
}

/// Tubes of a single patch whose first and last rows are the same: the mean derivative around
/// them is zero, and the preconditioner has nothing to go by.
TEST(ClosedPatches, WithZeroMeanDerivativeAreHitLikeOthers) {
    Random random(63);
    for (int degree = 3; degree <= 8; ++degree) {
        PatchData tube{degree, 1 + degree % 3, {}, {}, {}};
        for (int i = 0; i <= degree; ++i)
            for (int j = 0; j <= tube.degree_v; ++j) {
                const double turn = 2 * std::numbers::pi * (i % degree) / degree;
                tube.points.emplace_back(30 * std::cos(turn), 30 * std::sin(turn),
                                         50.0 * j / tube.degree_v, 1);
            }
        const SurfaceModel model = ShapeBuilder().face({tube}).model();
        const Tracer tracer(model), clipping(model, {.clipping_only = true});
        const ExactPatch exact(model.patch(0));
        for (int i = 0; i < 300; ++i) {
            const Vec3 target(uniform(random, -15, 15), uniform(random, -15, 15),
                              uniform(random, 5, 45));
            const Vec3 direction = random_direction(random);
            const Ray ray = ray_through(target - direction * 200, direction);
            const std::vector<Vec2> places = brute_force_roots(model.patch(0), ray);
            for (const Tracer* each : {&tracer, &clipping}) {
                const std::vector<Hit> hits = each->all(ray);
                EXPECT_EQ(hits.size(), places.size()) << degree << ' ' << i;
                for (const Vec2& uv : places)
                    if (const auto root = exact_root(exact, ray, uv)) {
                        EXPECT_TRUE(among(hits, *root)) << degree << ' ' << i;
                    }
            }
        }
    }
}

/// A sheet folded back on itself, symmetric about its crease: x = (2 u - 1)^2 has no mean slope.
TEST(SymmetricPatches, WithZeroMeanDerivativeGiveBothSheets) {
    const SurfaceModel model = ShapeBuilder().face({extruded({10, -10, 10}, {-5, 0, 5})}).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (const double x : {9.0, 4.0, 1.0, 0.01, 1e-4}) {
        const Ray ray = ray_through(Vec3(x, 5, -20), Vec3(0, 0, 1));
        const double half = 5 * std::sqrt(x / 10);
        for (const Tracer* each : {&tracer, &clipping}) {
            const std::vector<Hit> hits = each->all(ray);
            ASSERT_EQ(hits.size(), 2u) << x;
            EXPECT_NEAR(hits[0].t, 20 - half, 1e-10);
            EXPECT_NEAR(hits[1].t, 20 + half, 1e-10);
        }
    }
}

} // namespace
} // namespace keiko
