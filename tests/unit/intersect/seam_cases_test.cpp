#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include "tests/support/squares.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Slanted rays across the seam, more of them the nearer to it.
std::vector<Ray> across_seam(int count) {
    Random random(131);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const double x = std::pow(10, -uniform(random, 0, 9)) * (i % 2 == 0 ? 1 : -1);
        const Vec3 target(x, uniform(random, -9, 9), 0);
        const Vec3 from = target + Vec3(uniform(random, -4, 4), uniform(random, -4, 4), 20);
        rays.push_back(ray_through(from, target - from));
    }
    return rays;
}

TEST(Gaps, WithinToleranceLetNoRayThrough) {
    for (const double gap : {1e-3, 1e-6, 0.0})
        for (const double fold : {0.0, 0.2, -0.5}) {
            const SurfaceModel model = squares(gap, 2e-3, fold);
            const Tracer tracer(model), clipping(model, {.clipping_only = true});
            for (const Ray& ray : across_seam(5000))
                for (const Tracer* each : {&tracer, &clipping}) {
                    ASSERT_TRUE(each->any(ray)) << gap << ' ' << fold << ' ' << ray.origin;
                    EXPECT_EQ(each->all(ray).size(), 1u) << gap << ' ' << fold << ' ' << ray.origin;
                }
        }
}

/// Sheets that overlap within the tolerance: a ray there meets both, and it is one hit.
TEST(Overlaps, WithinToleranceCountOnce) {
    for (const double overlap : {1e-3, 1e-6}) {
        const SurfaceModel model = squares(-overlap, 2e-3, 0);
        const Tracer tracer(model), clipping(model, {.clipping_only = true});
        for (const Ray& ray : across_seam(5000))
            for (const Tracer* each : {&tracer, &clipping})
                ASSERT_EQ(each->all(ray).size(), 1u) << overlap << ' ' << ray.origin;
    }
}

/// Two sheets that lap over each other by half the tolerance, one half of it above the other: the
/// lower the ray, the farther apart along it are the two hits that are one.
TEST(Overlaps, SeenAtALowAngleCountOnce) {
    constexpr double tolerance = 2e-3;
    SurfaceModel model = squares(-tolerance / 2, tolerance, 0);
    const Patch& lifted = model.patches[1];
    for (std::size_t i = 0; i < 4; ++i)
        model.control_points[lifted.first_point + i].z += tolerance / 2;
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    Random random(133);
    for (const double slope : {1.0, 0.3, 0.1, 0.05})
        for (int i = 0; i < 500; ++i) {
            const Vec3 target(uniform(random, -2e-3, 2e-3), uniform(random, -9, 9), 0);
            const Vec3 direction(random() % 2 == 0 ? 1 : -1, uniform(random, -1, 1), -slope);
            const Ray ray = ray_through(target - direction, direction);
            for (const Tracer* each : {&tracer, &clipping})
                ASSERT_EQ(each->all(ray).size(), 1u) << slope << ' ' << target;
        }
}

/// A sheet of metal thinner than the tolerance of its edges, without the faces along its rim: a
/// ray near the rim goes in and out.
TEST(ThinSheets, AreTwoHitsWithinToleranceOfTheirEdges) {
    constexpr double tolerance = 2e-3;
    for (const double thickness : {1e-4, 1e-3}) {
        ShapeBuilder builder;
        for (const double z : {0.0, thickness}) {
            const std::uint32_t rim = builder.edge(tolerance);
            builder.face({rectangle(-10, 10, -10, 10, z)},
                         {polygon({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}, rim)});
        }
        SurfaceModel model = builder.model();
        model.faces[0].reversed = true;
        const Tracer tracer(model), clipping(model, {.clipping_only = true});
        for (const double x : {0.0, 9.0, 9.999, 9.99999})
            for (const Tracer* each : {&tracer, &clipping})
                EXPECT_EQ(each->all(ray_through(Vec3(x, 1, 5), Vec3(0, 0, -1))).size(), 2u)
                    << thickness << ' ' << x;
    }
}

TEST(Gaps, BeyondToleranceLetRaysThrough) {
    const Tracer tracer(squares(1e-2, 1e-3, 0));
    for (const double x : {0.0, 1e-3, -3e-3, 3.9e-3})
        EXPECT_FALSE(tracer.any(ray_through(Vec3(x, 1, 5), Vec3(0, 0, -1)))) << x;
    for (const double x : {5.1e-3, -6e-3, 1.0})
        EXPECT_TRUE(tracer.any(ray_through(Vec3(x, 1, 5), Vec3(0, 0, -1)))) << x;
}

/// A drum whose mantle is closed along a line that the file has no edge for. Rays at the place
/// where that line ends on the rim are within the rim's tolerance of the mantle: none may slip
/// through.
TEST(Vertices, AreTightWhereACurveWithoutAnEdgeEnds) {
    constexpr double turn = 2 * std::numbers::pi;
    ShapeBuilder builder;
    const std::uint32_t rim = builder.edge(1e-7), foot = builder.edge(1e-7);
    builder.face(cylinder(10, 20), {{line({0, 0}, {turn, 0}, foot), line({turn, 0}, {turn, 20}),
                                     line({turn, 20}, {0, 20}, rim), line({0, 20}, {0, 0})}});
    // The lid ends a little short of the rim, as lids do near vertices.
    builder.face({rectangle(-12, 12, -12, 12, 20)}, {circle(Vec2(0), 10 - 5e-7, rim)});
    const Tracer tracer(builder.model());
    Random random(134);
    std::size_t lost[2] = {0, 0};
    for (int i = 0; i < 8000; ++i) {
        const double angle = i % 2 == 0 ? 0 : uniform(random, 0, turn);
        const Vec3 target(10 * std::cos(angle), 10 * std::sin(angle), 20);
        // From above and from outside: the ray enters the drum there.
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        const Vec3 from = random_direction(random);
        if (!(from.z > 0.05 && from.dot(out) > 0.05)) continue;
        const Ray ray = ray_through(target + from * 30, -from, 29.9, 30.1);
        lost[i % 2] += !tracer.any(ray);
    }
    EXPECT_EQ(lost[0], 0u) << "at the vertex";
    EXPECT_EQ(lost[1], 0u) << "elsewhere on the rim";
}

/// A seam hit lies within its bound of where the ray meets the gap.
TEST(Seams, HitsSayHowFarOffTheyAre) {
    const Tracer tracer(squares(1e-3, 2e-3, 0));
    Random random(132);
    for (int i = 0; i < 2000; ++i) {
        const double x = uniform(random, -4.9e-4, 4.9e-4);
        const auto hit =
            tracer.nearest(ray_through(Vec3(x, uniform(random, -9, 9), 5), Vec3(0, 0, -1)));
        ASSERT_TRUE(hit);
        EXPECT_TRUE(has(hit->flags, HitFlags::seam));
        EXPECT_LE(std::abs(hit->position.x - x), hit->position_bound);
        EXPECT_LT(hit->position_bound, 2.1e-3);
    }
}

} // namespace
} // namespace keiko
