#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Whether one of the ray's hits is the point it was aimed at.
bool finds(const Tracer& tracer, const Ray& ray, const Vec3& target, double tolerance) {
    const std::vector<Hit> hits = tracer.all(ray);
    return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
        return (hit.position - target).length() <= std::max(tolerance, 2 * hit.position_bound);
    });
}

/// A ray through `target` that meets the tangent plane there at `angle` radians.
Ray grazing_ray(Random& random, const SurfaceDerivatives& s, double angle, double distance) {
    const Vec3 normal = *unit_normal(s, Vec2(0.5));
    const Vec3 u = s.du().normalized(), v = normal.cross(u);
    const double turn = uniform(random, 0, 6.2831);
    const Vec3 tangent = u * std::cos(turn) + v * std::sin(turn);
    const Vec3 direction = tangent * std::cos(angle) - normal * std::sin(angle);
    return ray_through(s.position() - direction * distance, direction);
}

struct Kind {
    const char* name;
    int degree_u, degree_v;
    double rough, weights;
    Vec3 offset;
    int rays;
};

class ConstructedRoots : public testing::TestWithParam<Kind> {};

TEST_P(ConstructedRoots, AreAllFound) {
    const Kind kind = GetParam();
    Random random(21);
    SurfaceModel model;
    std::unique_ptr<Tracer> tracer, clipping;
    const double tolerance = 1e-8 + 1e-14 * kind.offset.length();
    for (int i = 0; i < kind.rays; ++i) {
        if (i % 1000 == 0) {
            model = ShapeBuilder()
                        .face({random_patch(random, kind.degree_u, kind.degree_v, kind.rough,
                                            kind.weights, kind.offset)})
                        .model();
            tracer = std::make_unique<Tracer>(model);
            clipping = std::make_unique<Tracer>(model, TracerOptions{.clipping_only = true});
        }
        const Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
        const SurfaceDerivatives s = evaluate(model.patch(0), uv, 2);
        const double distance = std::exp(uniform(random, 0, std::log(1e5)));
        Ray ray = ray_through(s.position() - random_direction(random) * distance, Vec3(0));
        ray.direction = s.position() - ray.origin;
        double sine = 1e-2;
        if (i % 2 == 0 && unit_normal(s, uv)) {
            const double angle = std::pow(10, -uniform(random, 1, 8));
            ray = grazing_ray(random, s, angle, distance);
            sine = angle;
        }
        // What the ray's own rounding moves it by, across and then along the surface.
        const double blur = tolerance + 2e-15 * (distance + kind.offset.length()) / sine;
        EXPECT_TRUE(finds(*tracer, ray, s.position(), blur)) << kind.name << " ray " << i;
        if (i % 5 == 0) {
            EXPECT_TRUE(finds(*clipping, ray, s.position(), blur))
                << kind.name << " ray " << i << " by clipping";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Patches, ConstructedRoots,
                         testing::Values(Kind{"Bicubic", 3, 3, 15, 1, Vec3(0), 40000},
                                         Kind{"Folded", 3, 3, 60, 1, Vec3(0), 10000},
                                         Kind{"Rational", 3, 3, 15, 100, Vec3(0), 20000},
                                         Kind{"WeightsThousandfold", 2, 2, 10, 1e6, Vec3(0), 10000},
                                         Kind{"Bilinear", 1, 1, 20, 1, Vec3(0), 10000},
                                         Kind{"Flat", 3, 1, 0, 1, Vec3(0), 10000},
                                         Kind{"DegreeTwentyFive", 25, 25, 15, 1, Vec3(0), 1000},
                                         Kind{"FarAway", 3, 3, 15, 1, Vec3(1e6, -1e6, 1e6), 10000}),
                         [](const auto& kind) { return std::string(kind.param.name); });

/// Rays aimed at what several patches share must not slip through between them.
TEST(SharedBorders, AreTight) {
    const std::vector<PatchData> patches = sphere(Vec3(3, 4, 5), 40);
    const SurfaceModel model = ShapeBuilder().face(patches).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    Random random(22);
    for (int i = 0; i < 20000; ++i) {
        // Multiples of 1/16 are where sub-patches may have been cut, 0 and 1 where patches end.
        Vec2 uv(std::floor(uniform(random, 0, 17)) / 16, uniform(random, 0, 1));
        if (i % 3 == 1) std::swap(uv.x, uv.y);
        if (i % 3 == 2) uv.y = std::floor(uniform(random, 0, 17)) / 16;
        const auto patch = static_cast<std::uint32_t>(i % 8);
        const Vec3 target = evaluate(model.patch(patch), uv, 0).position();
        Ray ray = ray_through(target + random_direction(random) * 100, Vec3(0));
        ray.direction = target - ray.origin;
        for (const Tracer* each : {&tracer, &clipping}) {
            const std::vector<Hit> hits = each->all(ray);
            // Rays low over the surface have larger errors, and say so.
            const auto at_target = [&](const Hit& hit) {
                return (hit.position - target).length() <= std::max(1e-8, hit.position_bound);
            };
            EXPECT_EQ(std::count_if(hits.begin(), hits.end(), at_target), 1) << i;
            EXPECT_LE(hits.size(), 2u) << i;
            EXPECT_TRUE(each->nearest(ray)) << i;
        }
    }
}

TEST(Origins, MayBeFarOutOrInside) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 1)).model());
    Random random(23);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 direction = random_direction(random);
        const Vec3 through = random_direction(random) * 0.9;
        for (const double distance : {0.0, 2.0, 1e3, 1e6}) {
            const Ray ray = ray_through(through - direction * distance, direction);
            const auto hit = tracer.nearest(ray);
            ASSERT_TRUE(hit) << distance;
            EXPECT_NEAR(hit->position.length(), 1, 1e-12);
            const double off = (hit->position - ray.at(hit->t)).length();
            EXPECT_LT(off, 1e-12 + 1e-14 * distance);
        }
    }
}

TEST(Tangency, IsFlaggedNotLost) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 10)).model());
    Random random(24);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 normal = random_direction(random);
        const Vec3 tangent = normal.cross(random_direction(random)).normalized();
        const std::vector<Hit> hits = tracer.all(ray_through(normal * 10 - tangent * 50, tangent));
        ASSERT_FALSE(hits.empty()) << i;
        for (const Hit& hit : hits) {
            EXPECT_LT((hit.position - normal * 10).length(), 1e-5);
            EXPECT_GT(hit.position_bound, (hit.position - normal * 10).length() / 100);
        }
    }
}

TEST(Tangency, OfARulingGivesItsEnds) {
    const Tracer tracer(ShapeBuilder().face(cylinder(10, 100)).model());
    const std::vector<Hit> hits = tracer.all(ray_through(Vec3(10, 0, -50), Vec3(0, 0, 1)));
    ASSERT_FALSE(hits.empty());
    EXPECT_NEAR(hits.front().t, 50, 1e-6);
    EXPECT_TRUE(has(hits.front().flags, HitFlags::tangential));
}

TEST(Tangency, InThePlaneOfAFaceGivesItsBorder) {
    const Tracer tracer(ShapeBuilder().face({rectangle(0, 10, 0, 20, 5)}).model());
    const auto hit = tracer.nearest(ray_through(Vec3(-3, -3, 5), Vec3(1, 2, 0)));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(has(hit->flags, HitFlags::tangential));
    EXPECT_LT((hit->position - Vec3(0, 3, 5)).length(), 1e-9);
}

} // namespace
} // namespace keiko
