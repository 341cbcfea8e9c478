#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include "tests/support/squares.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Mirror rays of rays from `eye` aimed at random points of one sphere patch, border included.
struct Mirrored {
    Hit hit;
    Ray ray;
};

std::vector<Mirrored> mirrored(const Tracer& tracer, const SurfaceModel& model, const Vec3& eye,
                               int count) {
    Random random(31);
    std::vector<Mirrored> result;
    for (int i = 0; i < count; ++i) {
        Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
        if (i % 4 == 1) uv.x = i % 8 == 1 ? 0 : 1;
        if (i % 4 == 2) uv.y = 0.25 * (i % 5);
        const auto patch = static_cast<std::uint32_t>(i % 8);
        const Vec3 target = evaluate(model.patch(patch), uv, 0).position();
        const Ray ray = ray_through(eye, (target - eye).normalized());
        const auto hit = tracer.nearest(ray);
        if (!hit) continue;
        result.push_back(
            {*hit, excluding(hit->root,
                             ray_through(hit->position, reflect(ray.direction, hit->normal)))});
    }
    return result;
}

TEST(MirrorRays, LeaveAConvexSurfaceForGood) {
    const SurfaceModel model = ShapeBuilder().face(sphere(Vec3(0), 20)).model();
    const Tracer tracer(model);
    const auto rays = mirrored(tracer, model, Vec3(35, 27, 19), 20000);
    EXPECT_GT(rays.size(), 19000u);
    for (const Mirrored& m : rays)
        EXPECT_FALSE(tracer.any(m.ray)) << m.hit.uv.x << ' ' << m.hit.uv.y;
}

TEST(MirrorRays, MeetAConcaveSurfaceAgain) {
    const SurfaceModel model = ShapeBuilder().face(sphere(Vec3(0), 20)).model();
    const Tracer tracer(model);
    for (const Vec3& eye : {Vec3(1, 2, 3), Vec3(19.999, 0.1, 0), Vec3(5, 19.36491, 0)}) {
        for (const Mirrored& m : mirrored(tracer, model, eye, 5000)) {
            // The chord that leaves at the same angle as it came in.
            const double chord = 2 * std::abs(m.ray.direction.dot(m.hit.position)) / 20 * 20;
            const auto next = tracer.nearest(m.ray);
            ASSERT_TRUE(next);
            EXPECT_NEAR(next->t, chord, 1e-9 * chord + 1e-7);
        }
    }
}

TEST(MirrorRays, MeetAConcaveSurfaceAgainAtLowAngles) {
    const SurfaceModel model = ShapeBuilder().face(sphere(Vec3(0), 20)).model();
    const Tracer tracer(model);
    Random random(32);
    for (int i = 0; i < 3000; ++i) {
        const Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
        const Vec3 p = evaluate(model.patch(0), uv, 0).position(), out = p.normalized();
        const auto hit = tracer.nearest(ray_through(Vec3(0), p));
        ASSERT_TRUE(hit);
        const Vec3 along = out.cross(random_direction(random)).normalized();
        const double angle = std::pow(10, -uniform(random, 0, 5));
        const Ray ray = excluding(
            hit->root, ray_through(hit->position, along * std::cos(angle) - out * std::sin(angle)));
        const auto next = tracer.nearest(ray);
        ASSERT_TRUE(next) << angle;
        EXPECT_NEAR(next->t / (40 * std::sin(angle)), 1, 1e-5) << angle;
    }
}

TEST(ShadowRays, DoNotMeetTheirOwnEnd) {
    const SurfaceModel model = ShapeBuilder().face(sphere(Vec3(0), 20)).model();
    const Tracer tracer(model);
    const Vec3 lamp(35, 27, 19);
    for (const Mirrored& m : mirrored(tracer, model, lamp, 5000)) {
        const Ray shadow = excluding(m.hit.root, ray_through(lamp, m.hit.position - lamp, 0, 1));
        EXPECT_FALSE(tracer.any(shadow));
        Ray longer = shadow;
        longer.t_max = 10;
        EXPECT_TRUE(tracer.any(longer)); // the far side, which is not excluded
    }
}

/// The squares, the second raised by the gap: what is open between the sheets is closed.
SurfaceModel step(double gap) {
    SurfaceModel model = squares(gap, 2 * gap, 0);
    const Patch& second = model.patches[1];
    for (std::size_t i = 0; i < 4; ++i) model.control_points[second.first_point + i].z += gap;
    return model;
}

TEST(MirrorRays, DoNotGetBehindTheNeighbourThroughTheirSeam) {
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5}) {
        const Tracer tracer(step(gap));
        Random random(33);
        int seams = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 target(uniform(random, -0.6, 0.6) * gap, uniform(random, -9, 9), 0);
            const Vec3 in(uniform(random, 0.2, 5), uniform(random, -1, 1), -1);
            const auto hit = tracer.nearest(ray_through(target - in * 20, in));
            ASSERT_TRUE(hit);
            seams += has(hit->flags, HitFlags::seam);
            const Ray mirrored =
                excluding(hit->root, ray_through(hit->position, reflect(in, hit->normal)));
            EXPECT_FALSE(tracer.any(mirrored)) << gap << ' ' << target << ' ' << in;
            EXPECT_FALSE(tracer.nearest(mirrored)) << gap << ' ' << target << ' ' << in;
        }
        EXPECT_GT(seams, 100);
    }
}

constexpr double right_angle = 1.5707963267948966;

/// Rays that the first of two squares in an inner corner mirrors beside their edge, from x within a
/// range.
std::vector<Ray> mirrored_beside_edge(const Tracer& tracer, int seed, double low, double high) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 target(uniform(random, low, high), uniform(random, -9, 9), 0);
        const Vec3 in(uniform(random, 0.2, 0.8), uniform(random, -1, 1), -1);
        const auto hit = tracer.nearest(ray_through(target - in, in));
        EXPECT_TRUE(hit);
        if (!hit || hit->face != 0) continue;
        rays.push_back(excluding(hit->root, ray_through(hit->position, reflect(in, hit->normal))));
    }
    return rays;
}

TEST(MirrorRays, MeetTheNeighbourInAnInnerCorner) {
    for (const double gap : {1e-2, 1e-4}) {
        const Tracer tracer(squares(gap, 2 * gap, right_angle));
        for (const Ray& mirrored : mirrored_beside_edge(tracer, 34, -10 * gap, 0.5 * gap)) {
            const auto next = tracer.nearest(mirrored);
            ASSERT_TRUE(next) << gap << ' ' << mirrored.origin << ' ' << mirrored.direction;
            EXPECT_EQ(next->face, 1u);
        }
    }
}

/// Files may turn faces against each other.
TEST(MirrorRays, MeetATurnedNeighbourInAnInnerCorner) {
    for (const double gap : {0.0, 5e-3}) {
        SurfaceModel model = squares(gap, 1e-2, right_angle);
        model.faces[1].reversed = !model.faces[1].reversed;
        const Tracer tracer(model);
        for (const Ray& mirrored : mirrored_beside_edge(tracer, 35, -2e-2, -5e-3))
            EXPECT_TRUE(tracer.any(mirrored)) << gap << ' ' << mirrored.origin;
    }
}

TEST(RootBox, HoldsTheHitAndLittleElse) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 20)).model());
    const auto hit = tracer.nearest(ray_through(Vec3(35, 27, 19), Vec3(-35, -26, -18)));
    ASSERT_TRUE(hit);
    EXPECT_TRUE(hit->root.uv.contains(hit->uv));
    EXPECT_EQ(hit->root.patch, hit->patch);
    EXPECT_LT(hit->root.uv.size(), 1e-7);
}

} // namespace
} // namespace keiko
