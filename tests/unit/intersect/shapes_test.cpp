#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

PrincipalCurvatures curvatures(const Hit& hit) {
    return principal_curvatures(derivatives_of(hit), hit.normal);
}

TEST(Sphere, HasExactDistanceNormalAndCurvature) {
    const Vec3 center(10, -20, 30);
    const double radius = 70;
    const SurfaceModel model = ShapeBuilder().face(sphere(center, radius)).model();
    const Tracer tracer(model, {.second_derivatives = true});
    Random random(11);
    for (int i = 0; i < 20000; ++i) {
        Ray ray = ray_through(center + random_direction(random) * 300, Vec3(0));
        const Vec3 target = center + random_direction(random) * uniform(random, 0, 1.3 * radius);
        ray.direction = (target - ray.origin).normalized();
        const Vec3 to = center - ray.origin;
        const double foot = to.dot(ray.direction);
        const double half2 = radius * radius - (to - ray.direction * foot).length2();
        if (std::abs(half2) < 1e-6) continue;
        const std::vector<Hit> hits = tracer.all(ray);
        ASSERT_EQ(hits.size(), half2 > 0 ? 2u : 0u) << i;
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const double t = foot + (k == 0 ? -1 : 1) * std::sqrt(half2);
            const Vec3 outward = (ray.at(t) - center) / radius;
            EXPECT_NEAR(hits[k].t, t, 1e-9);
            EXPECT_LT((hits[k].position - ray.at(t)).length(), hits[k].position_bound);
            EXPECT_LT(hits[k].position_bound, 1e-8);
            EXPECT_NEAR((hits[k].position - center).length(), radius, 1e-12);
            EXPECT_NEAR(std::abs(hits[k].normal.dot(outward)), 1, 1e-12);
            const PrincipalCurvatures c = curvatures(hits[k]);
            EXPECT_NEAR(std::abs(c.k1), 1 / radius, 1e-8);
            EXPECT_NEAR(c.gaussian(), 1 / (radius * radius), 1e-10);
        }
    }
}

TEST(Sphere, HasANormalAtItsPoles) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 5)).model());
    for (const Vec3& off : {Vec3(0), Vec3(1e-9, 0, 0), Vec3(0, -1e-12, 0), Vec3(1e-14, 1e-13, 0)}) {
        const std::vector<Hit> hits = tracer.all(ray_through(Vec3(0, 0, 20) + off, Vec3(0, 0, -1)));
        ASSERT_EQ(hits.size(), 2u) << off.x << ' ' << off.y;
        EXPECT_NEAR(hits[0].t, 15, 1e-12);
        EXPECT_NEAR(hits[1].t, 25, 1e-12);
        for (const Hit& hit : hits) {
            EXPECT_NEAR(std::abs(hit.normal.z), 1, 1e-9);
            EXPECT_FALSE(has(hit.flags, HitFlags::tangential));
        }
    }
}

TEST(Cylinder, IsHitOnceThroughEachWall) {
    const double radius = 12;
    const Tracer tracer(ShapeBuilder().face(cylinder(radius, 100)).model(),
                        {.second_derivatives = true});
    Random random(12);
    for (int i = 0; i < 5000; ++i) {
        const double x = uniform(random, -11.99, 11.99), z = uniform(random, 1, 99);
        const std::vector<Hit> hits = tracer.all(ray_through(Vec3(x, -50, z), Vec3(0, 2, 0)));
        ASSERT_EQ(hits.size(), 2u);
        const double half = std::sqrt(radius * radius - x * x);
        EXPECT_NEAR(hits[0].t, (50 - half) / 2, 1e-10);
        EXPECT_NEAR(hits[1].t, (50 + half) / 2, 1e-10);
        EXPECT_NEAR(curvatures(hits[0]).gaussian(), 0, 1e-12);
        EXPECT_NEAR(std::abs(curvatures(hits[0]).mean()), 0.5 / radius, 1e-10);
    }
}

TEST(Torus, GivesAllFourHits) {
    const double major = 50, minor = 10;
    const Tracer tracer(ShapeBuilder().face(torus(major, minor)).model());
    Random random(13);
    for (int i = 0; i < 5000; ++i) {
        const double z = uniform(random, -9.9, 9.9), y = uniform(random, -38, 38);
        const std::vector<Hit> hits = tracer.all(ray_through(Vec3(-200, y, z), Vec3(1, 0, 0)));
        const double tube = std::sqrt(minor * minor - z * z);
        const double outer = major + tube, inner = major - tube;
        std::vector<double> x{-std::sqrt(outer * outer - y * y), std::sqrt(outer * outer - y * y)};
        if (inner > std::abs(y)) {
            x.push_back(-std::sqrt(inner * inner - y * y));
            x.push_back(std::sqrt(inner * inner - y * y));
        }
        std::sort(x.begin(), x.end());
        ASSERT_EQ(hits.size(), x.size()) << i;
        for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(hits[k].t, 200 + x[k], 1e-8);
    }
}

TEST(Saddle, GivesBothHitsAndItsCurvature) {
    // z = x y / 10 over [-10, 10]^2
    const Tracer tracer(
        ShapeBuilder()
            .face({bilinear({-10, -10, 10}, {10, -10, -10}, {-10, 10, -10}, {10, 10, 10})})
            .model(),
        {.second_derivatives = true});
    Random random(14);
    for (int i = 0; i < 5000; ++i) {
        const double z = uniform(random, 0.001, 3), c = uniform(random, -3, 3);
        // Along x = y + c at height z: y^2 + c y = 10 z.
        const Ray ray = ray_through(Vec3(-20 + c, -20, z), Vec3(1, 1, 0));
        const std::vector<Hit> hits = tracer.all(ray);
        const double root = std::sqrt(c * c / 4 + 10 * z);
        std::vector<double> y;
        for (const double at : {-c / 2 - root, -c / 2 + root})
            if (std::max(std::abs(at), std::abs(at + c)) < 10) y.push_back(at);
        ASSERT_EQ(hits.size(), y.size()) << i;
        for (std::size_t k = 0; k < y.size(); ++k) {
            EXPECT_NEAR(hits[k].t, 20 + y[k], 1e-9);
            const double slope2 = (hits[k].position.x * hits[k].position.x +
                                   hits[k].position.y * hits[k].position.y) /
                                  100;
            const double gaussian = -0.01 / ((1 + slope2) * (1 + slope2));
            EXPECT_NEAR(curvatures(hits[k]).gaussian(), gaussian, 1e-10);
        }
    }
}

TEST(Plane, IsHitByAxisParallelRaysWithSignedZeros) {
    const Tracer tracer(ShapeBuilder().face({rectangle(0, 10, 0, 20, 5)}).model());
    for (const double zero : {0.0, -0.0})
        for (const double x : {0.0, 3.0, 10.0})
            for (const double y : {0.0, 7.0, 20.0}) {
                const auto hit = tracer.nearest(ray_through(Vec3(x, y, 40), Vec3(zero, -zero, -2)));
                ASSERT_TRUE(hit) << x << ' ' << y;
                EXPECT_DOUBLE_EQ(hit->t, 17.5);
                EXPECT_DOUBLE_EQ(hit->position.z, 5);
            }
    EXPECT_FALSE(tracer.any(ray_through(Vec3(10.001, 7, 40), Vec3(0, 0, -1))));
    EXPECT_FALSE(tracer.any(ray_through(Vec3(3, 7, 40), Vec3(0, 0, 1))));
}

TEST(Placement, MirrorsAndScalesHits) {
    Random random(15);
    const Affine mirror{.rows = {Vec3(-2, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 2)},
                        .translation = Vec3(5, 6, 7)};
    const Affine map = mirror * Affine::rotate(Vec3(1, 2, 3), 0.7);
    const PatchData patch = random_patch(random, 3, 3, 20, 4);
    const SurfaceModel plain = ShapeBuilder().face({patch}).model();
    const Tracer here(plain, {.second_derivatives = true});
    const Tracer there(
        ShapeBuilder().face({patch}).place({Affine::translate({1e4, 0, 0}), map}).model(),
        {.second_derivatives = true});
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 origin = random_direction(random) * 150;
        const Vec3 target(uniform(random, -50, 50), uniform(random, -50, 50), 0);
        const auto a = here.nearest(ray_through(origin, target - origin));
        const auto b = there.nearest(ray_through(map.point(origin), map.vector(target - origin)));
        ASSERT_EQ(a.has_value(), b.has_value()) << i;
        if (!a) continue;
        ++hits;
        EXPECT_EQ(b->instance, 1u);
        EXPECT_NEAR(a->t, b->t, 1e-9);
        EXPECT_LT((map.point(a->position) - b->position).length(), 1e-7);
        EXPECT_LT((b->dpdu - map.vector(a->dpdu)).length(), 1e-4);
        EXPECT_LT((b->second->duv - map.vector(a->second->duv)).length(), 1e-3);
        EXPECT_LT((b->normal - b->dpdu.cross(b->dpdv).normalized()).length(), 1e-9);
    }
    EXPECT_GT(hits, 500);
}

} // namespace
} // namespace keiko
