#include "keiko/base/error.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

SurfaceModel layers() {
    Random random(51);
    ShapeBuilder builder;
    for (int i = 0; i < 6; ++i)
        builder.face({random_patch(random, 3, 3, 15, 1 + i, Vec3(0, 0, 10.0 * i))});
    return builder.model();
}

std::vector<Ray> random_rays(int count) {
    Random random(52);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        Ray ray = ray_through(random_direction(random) * 200, Vec3(0));
        ray.direction =
            Vec3(uniform(random, -60, 60), uniform(random, -60, 60), uniform(random, -20, 80)) -
            ray.origin;
        rays.push_back(ray);
    }
    return rays;
}

TEST(Rays, WithoutMeaningHitNothing) {
    const Tracer tracer(layers());
    const Vec3 origin(0, 0, 500), down(0, 0, -1);
    ASSERT_TRUE(tracer.any(ray_through(origin, down)));
    for (const double bad : {nan, infinity, -infinity}) {
        for (unsigned k = 0; k < 3; ++k) {
            Vec3 broken = origin;
            broken[k] = bad;
            EXPECT_FALSE(tracer.any(ray_through(broken, down)));
            broken = down;
            broken[k] = bad;
            EXPECT_FALSE(tracer.nearest(ray_through(origin, broken)));
        }
    }
    for (const double far : {1e140, 1e153, 1.4e154, 1e200, 1e308}) {
        EXPECT_FALSE(tracer.any(ray_through(Vec3(0, 0, far), down)));
        EXPECT_FALSE(tracer.nearest(ray_through(Vec3(-far, far, 0), Vec3(1, -1, 0))));
    }
    EXPECT_FALSE(tracer.any(ray_through(origin, Vec3(0))));
    EXPECT_FALSE(tracer.any(ray_through(origin, down, nan)));
    EXPECT_FALSE(tracer.any(ray_through(origin, down, 0, nan)));
    EXPECT_FALSE(tracer.any(ray_through(origin, down, 3, 2)));
    EXPECT_TRUE(tracer.all(ray_through(Vec3(nan), Vec3(nan))).empty());
}

TEST(Rays, KeepTheirRangeInDouble) {
    const Tracer tracer(layers());
    for (const Ray& ray : random_rays(500)) {
        const std::vector<Hit> hits = tracer.all(ray);
        for (std::size_t k = 0; k < hits.size(); ++k) {
            Ray part = ray;
            part.t_min = part.t_max = hits[k].t;
            ASSERT_TRUE(tracer.any(part));
            part.t_min = std::nextafter(hits[k].t, infinity);
            part.t_max = infinity;
            EXPECT_EQ(tracer.all(part).size(), hits.size() - k - 1);
            part.t_min = -infinity;
            part.t_max = std::nextafter(hits[k].t, -infinity);
            EXPECT_EQ(tracer.all(part).size(), k);
        }
    }
}

TEST(Rays, MayRunBackwards) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 1)).model());
    const Ray ray = ray_through(Vec3(5, 0, 0), Vec3(1, 0, 0), -10, 0);
    const std::vector<Hit> hits = tracer.all(ray);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].t, -6, 1e-12);
    EXPECT_NEAR(hits[1].t, -4, 1e-12);
}

/// Alone and in a packet.
TEST(Rays, MayRunBackwardsFromWithinTheScene) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 1)).model());
    std::vector<Ray> rays;
    for (int i = 0; i < 16; ++i)
        rays.push_back(ray_through(Vec3(0.05 * i, 0.1, 0.05), Vec3(1, 1e-3 * i, 0), -20, 20));
    const auto together = tracer.all(std::span<const Ray>(rays));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::vector<Hit> hits = tracer.all(rays[i]);
        ASSERT_EQ(hits.size(), 2u) << i;
        EXPECT_LT(hits[0].t, 0);
        EXPECT_GT(hits[1].t, 0);
        EXPECT_EQ(together[i].size(), 2u) << i;
        EXPECT_EQ(tracer.nearest(rays[i])->t, hits[0].t);
    }
}

/// Coordinates may be as large beside the body as doubles can still hold it.
TEST(Eyes, OfSmallBodiesFarFromTheOriginSee) {
    for (const double away : {0.0, 1e6, 1e9}) {
        const Vec3 center(away, away, -away);
        const Tracer tracer(ShapeBuilder().face(sphere(center, 1)).model());
        EXPECT_TRUE(tracer.nearest(ray_through(center + Vec3(0.5, 0, 0), Vec3(-1, 0, 0)))) << away;
    }
}

TEST(Threads, DoNotChangeAHit) {
    const SurfaceModel model = layers();
    Job alone, both;
    alone.threads = 1;
    both.threads = 2;
    const Tracer one(model, {}, alone), two(model, {}, both);
    const std::vector<Ray> rays = random_rays(3000);
    const auto batch = one.nearest(std::span<const Ray>(rays));
    const auto batch_all = two.all(std::span<const Ray>(rays));
    const auto batch_any = two.any(std::span<const Ray>(rays));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto a = one.nearest(rays[i]), b = two.nearest(rays[i]);
        ASSERT_EQ(a.has_value(), b.has_value());
        ASSERT_EQ(a.has_value(), batch[i].has_value());
        ASSERT_EQ(a.has_value(), batch_any[i]);
        ASSERT_EQ(a.has_value(), !batch_all[i].empty());
        if (!a) continue;
        EXPECT_EQ(a->t, b->t);
        EXPECT_EQ(a->uv, b->uv);
        EXPECT_EQ(a->patch, b->patch);
        EXPECT_EQ(a->t, batch[i]->t);
        EXPECT_EQ(a->position, batch[i]->position);
        EXPECT_EQ(a->t, batch_all[i].front().t);
    }
}

TEST(Modes, AgreeOnEveryRay) {
    const SurfaceModel model = layers();
    const Tracer proving(model), clipping(model, {.clipping_only = true});
    for (const Ray& ray : random_rays(5000)) {
        const auto a = proving.all(ray), b = clipping.all(ray);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_LE((a[k].position - b[k].position).length(),
                      a[k].position_bound + b[k].position_bound);
            EXPECT_FALSE(has(a[k].flags, HitFlags::clipped));
            EXPECT_TRUE(has(b[k].flags, HitFlags::clipped));
        }
    }
}

TEST(Build, ReportsProgressAndStops) {
    double last = 0;
    Job job;
    job.progress = [&](const Progress& p) {
        EXPECT_EQ(p.stage, "build");
        last = p.fraction;
    };
    const Tracer tracer(layers(), {}, job);
    EXPECT_EQ(last, 1);
    EXPECT_GT(tracer.statistics().sub_patches, 0u);
    EXPECT_GT(tracer.statistics().bytes, 0u);
    std::stop_source stop;
    stop.request_stop();
    job.stop = stop.get_token();
    EXPECT_THROW(Tracer(layers(), {}, job), Cancelled);
}

TEST(Build, TakesAnEmptyModel) {
    const Tracer tracer(SurfaceModel{});
    EXPECT_FALSE(tracer.any(ray_through(Vec3(0), Vec3(0, 0, 1))));
    EXPECT_TRUE(tracer.bounds().empty());
}

TEST(Placements, ThatAreFlatOrShearedBeyondAllMeasureAreRefused) {
    SurfaceModel model = layers();
    Affine& placement = model.instances.front().transform;
    for (const Vec3& row : {Vec3(0), Vec3(0, 0, 1e-7), Vec3(1e4, 0, 1)}) {
        placement = Affine{};
        placement.rows[2] = row;
        EXPECT_THROW(Tracer{model}, Error) << row;
    }
    for (const Vec3& row : {Vec3(0, 0, 1e-3), Vec3(100, 0, 1), Vec3(0, 0, -7)}) {
        placement.rows[2] = row;
        EXPECT_NO_THROW(Tracer{model}) << row;
    }
}

TEST(Shapes, WithoutAreaAreNotHit) {
    const PatchData segment{
        3,
        1,
        {Vec4(-5, 0, 0, 1), Vec4(7, 0, 0, 1), Vec4(-2, 0, 0, 1), Vec4(1, 0, 0, 1), Vec4(6, 0, 0, 2),
         Vec4(-6, 0, 0, 2), Vec4(3, 0, 0, 1), Vec4(5, 0, 0, 1)},
        {},
        {}};
    const PatchData point = bilinear({1, 1, 5}, {1, 1, 5}, {1, 1, 5}, {1, 1, 5});
    const Tracer tracer(
        ShapeBuilder().face({segment}).face({point}).face({rectangle(-9, 9, -9, 9, -20)}).model());
    for (const Vec3& through : {Vec3(0.5, 0, 0), Vec3(0), Vec3(1, 1, 5)}) {
        const std::vector<Hit> hits =
            tracer.all(ray_through(through + Vec3(3, 4, 30), Vec3(-3, -4, -30)));
        ASSERT_EQ(hits.size(), 1u);
        EXPECT_EQ(hits[0].face, 2u);
    }
}

TEST(Shapes, MayBeCollapsedOrSlivers) {
    // A patch collapsed to a triangle, and a strip 10,000 times as long as wide.
    const PatchData triangle = bilinear({0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 10, 0});
    const PatchData strip = bilinear({0, 0, -5}, {1000, 0, -5}, {0, 0.1, -5}, {1000, 0.1, -5});
    const Tracer tracer(ShapeBuilder().face({triangle}).face({strip}).model());
    Random random(53);
    for (int i = 0; i < 5000; ++i) {
        const double a = uniform(random, 0, 10), b = uniform(random, 0, 10);
        const auto hit = tracer.nearest(ray_through(Vec3(a, b, 10), Vec3(0, 0, -1)));
        ASSERT_EQ(hit && hit->face == 0, a + b < 10);
        const Vec3 on_strip(uniform(random, 11, 1000), uniform(random, 0, 0.1), -5);
        const Vec3 origin = on_strip + Vec3(uniform(random, -500, 500), 300, 400);
        ASSERT_TRUE(tracer.any(ray_through(origin, on_strip - origin)));
    }
}

} // namespace
} // namespace keiko
