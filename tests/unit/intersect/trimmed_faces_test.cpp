#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

LoopData square(double half) {
    return polygon({Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)});
}

TEST(TrimmedPlane, HasAHoleWhereItsLoopSays) {
    const SurfaceModel model =
        ShapeBuilder()
            .face({rectangle(-10, 10, -10, 10, 0)}, {square(8), circle(Vec2(1, 2), 3)})
            .model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    EXPECT_GT(tracer.statistics().sub_patches_mixed, 0u);
    Random random(41);
    for (int i = 0; i < 20000; ++i) {
        const double x = uniform(random, -11, 11), y = uniform(random, -11, 11);
        const bool material =
            std::max(std::abs(x), std::abs(y)) < 8 && std::hypot(x - 1, y - 2) > 3;
        const Ray ray = ray_through(Vec3(x, y, 5), Vec3(0, 0, -1));
        ASSERT_EQ(tracer.any(ray), material) << x << ' ' << y;
        ASSERT_EQ(clipping.any(ray), material) << x << ' ' << y;
    }
}

TEST(TrimmedSphere, IsCutInItsLongitudeAndLatitude) {
    // A window of 1 rad by 0.5 rad whose corners lie inside different patches.
    const std::vector<Vec2> corners{{1.2, -0.2}, {2.2, -0.2}, {2.2, 0.3}, {1.2, 0.3}};
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 10), {polygon(corners)}).model());
    EXPECT_GT(tracer.statistics().sub_patches_trimmed_away, 0u);
    Random random(42);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const double longitude = uniform(random, 0.8, 2.6), latitude = uniform(random, -0.5, 0.6);
        const bool material =
            longitude > 1.2 && longitude < 2.2 && latitude > -0.2 && latitude < 0.3;
        const Vec3 p(std::cos(longitude) * std::cos(latitude),
                     std::sin(longitude) * std::cos(latitude), std::sin(latitude));
        ASSERT_EQ(tracer.any(ray_through(p * 20, -p, 0, 15)), material)
            << longitude << ' ' << latitude;
        hits += material;
    }
    EXPECT_GT(hits, 1000);
}

TEST(Leaves, ThatAreTrimmedAwayDoNotExist) {
    Random random(43);
    const PatchData patch = random_patch(random, 3, 3, 30, 1);
    const Tracer whole(ShapeBuilder().face({patch}).model());
    const Tracer corner(ShapeBuilder().face({patch}, {circle(Vec2(0.2, 0.2), 0.1)}).model());
    EXPECT_LT(corner.statistics().sub_patches, whole.statistics().sub_patches / 2 + 1);
}

/// Two squares that should meet at x = 0 but leave a gap there.
SurfaceModel gapped(double gap, double tolerance) {
    ShapeBuilder builder;
    const std::uint32_t edge = builder.edge(tolerance);
    for (const double side : {-1.0, 1.0}) {
        const double inner = side * gap / 2, outer = side * 10;
        builder.face(
            {rectangle(std::min(inner, outer), std::max(inner, outer), -10, 10, 0)},
            {polygon({Vec2(inner, -10), Vec2(outer, -10), Vec2(outer, 10), Vec2(inner, 10)},
                     edge)});
    }
    return builder.model();
}

TEST(Seams, AreTightWithinTheirEdgesTolerance) {
    const Tracer sewn(gapped(1e-3, 1e-3));
    const Ray ray = ray_through(Vec3(1e-5, 3, 5), Vec3(0, 0, -1));
    const auto hit = sewn.nearest(ray);
    ASSERT_TRUE(hit);
    EXPECT_TRUE(has(hit->flags, HitFlags::seam));
    ASSERT_TRUE(hit->seam);
    EXPECT_EQ(*hit->seam, 0u);
    EXPECT_LT((hit->position - Vec3(1e-5, 3, 0)).length(), hit->position_bound);
    EXPECT_EQ(sewn.all(ray).size(), 1u);
}

TEST(Seams, LeakBeyondToleranceAndBeyondJoin) {
    const Ray ray = ray_through(Vec3(1e-5, 3, 5), Vec3(0, 0, -1));
    EXPECT_FALSE(Tracer(gapped(1e-3, 1e-4)).any(ray));
    EXPECT_FALSE(Tracer(gapped(1e-3, 1.0), {.join = 1e-4}).any(ray));
    EXPECT_FALSE(Tracer(gapped(1e-3, 0.0)).any(ray));
}

TEST(Seams, LeaveRealHitsAlone) {
    const Tracer sewn(gapped(1e-3, 1e-3));
    Random random(44);
    for (int i = 0; i < 2000; ++i) {
        const double x = uniform(random, 0.001, 9.9) * (i % 2 == 0 ? 1 : -1);
        const auto hit =
            sewn.nearest(ray_through(Vec3(x, uniform(random, -9.9, 9.9), 5), Vec3(0, 0, -1)));
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->flags, HitFlags::none);
    }
    EXPECT_FALSE(sewn.any(ray_through(Vec3(10.01, 0, 5), Vec3(0, 0, -1))));
}

} // namespace
} // namespace keiko
