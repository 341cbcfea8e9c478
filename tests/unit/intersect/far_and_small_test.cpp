#include "tests/support/exact_hits.h"
#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

const Vec3 far_off(1e6, -1e6, 1e6);

/// Written far from the origin, and placed there: every hit within its bound of the closed form,
/// and the bound no more than some last places of the coordinates.
TEST(FarParts, AreHitWithinSomeLastPlacesOfTheirCoordinates) {
    const SurfaceModel written = ShapeBuilder().face(sphere(far_off, 50)).model();
    const SurfaceModel placed =
        ShapeBuilder().face(sphere(Vec3(0), 50)).place({Affine::translate(far_off)}).model();
    Random random(81);
    for (const SurfaceModel* model : {&written, &placed}) {
        const Tracer tracer(*model);
        for (int i = 0; i < 5000; ++i) {
            const Vec3 out = random_direction(random), aim = random_direction(random) * 40;
            const Vec3 eye = far_off + out * uniform(random, 60, 5000);
            const Ray ray = ray_through(eye, far_off + aim - eye);
            const std::vector<Hit> hits = tracer.all(ray);
            ASSERT_EQ(hits.size(), 2u) << i;
            for (const Hit& hit : hits) {
                const LongVec3 from = lengthened(hit.position) - lengthened(far_off);
                EXPECT_LE(off_line(ray, lengthened(hit.position)), hit.position_bound);
                EXPECT_NEAR(static_cast<double>(from.length()), 50, 2e-9);
                EXPECT_LT(hit.position_bound, 1e-6);
            }
        }
    }
}

/// A quarter round of 0.1 mm along a 1 m edge. Mirrored off its convex side a ray is gone; inside
/// it goes round from chord to chord.
class Fillet : public testing::Test {
protected:
    static PatchData quarter_round() {
        PatchData all = cylinder(0.1, 1000)[0];
        return all;
    }
    const SurfaceModel model_ = ShapeBuilder().face({quarter_round()}).model();
    const Tracer tracer_{model_};

    static Ray mirrored(const Hit& hit, const Vec3& direction) {
        return excluding(hit.root, ray_through(hit.position, reflect(direction, hit.normal)));
    }
};

TEST_F(Fillet, OfATenthMillimetreDoesNotHitItself) {
    Random random(82);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const double turn = uniform(random, 0, std::numbers::pi / 2);
        const Vec3 target(0.1 * std::cos(turn), 0.1 * std::sin(turn), uniform(random, 0, 1000));
        const Vec3 out = Vec3(target.x, target.y, 0).normalized();
        // From the normal down to 1e-4 rad over the surface.
        const Vec3 side = out.cross(random_direction(random)).normalized();
        const double height = std::pow(10, -uniform(random, 0, 4));
        const Vec3 eye = target + (out * height + side).normalized() * 2000;
        const Vec3 direction = (target - eye).normalized();
        const auto hit = tracer_.nearest(ray_through(eye, direction));
        if (!hit) continue; // rounded clear of it, or beyond its ends
        ++hits;
        EXPECT_FALSE(tracer_.any(mirrored(*hit, direction))) << i << ' ' << height;
    }
    EXPECT_GT(hits, 19000);
}

TEST_F(Fillet, IsHitAgainFromInsideAsOftenAsItShould) {
    Random random(83);
    for (int i = 0; i < 5000; ++i) {
        // Level rays in the round: the chord's far end is on the quarter or past it.
        const double turn = uniform(random, 0.05, std::numbers::pi / 2 - 0.05);
        const double slant = uniform(random, 0.02, 1.5); // of the chord to the tangent
        const Vec3 p(0.1 * std::cos(turn), 0.1 * std::sin(turn), 500);
        const auto hit = tracer_.nearest(ray_through(Vec3(0, 0, 500), Vec3(p.x, p.y, 0)));
        ASSERT_TRUE(hit);
        const Vec3 tangent(-std::sin(turn), std::cos(turn), 0);
        const Vec3 inwards(-std::cos(turn), -std::sin(turn), 0);
        const Ray ray = excluding(
            hit->root,
            ray_through(hit->position, tangent * std::cos(slant) + inwards * std::sin(slant)));
        const double end = turn + 2 * slant;
        if (std::abs(end - std::numbers::pi / 2) < 1e-6) continue;
        const auto next = tracer_.nearest(ray);
        ASSERT_EQ(next.has_value(), end < std::numbers::pi / 2) << turn << ' ' << slant;
        if (next) {
            // The start is off the round by its own bound, which the low angle stretches.
            const double off = hit->position_bound / std::sin(slant) + next->position_bound;
            EXPECT_NEAR(next->t, 0.2 * std::sin(slant), off);
        }
    }
}

/// From so far that the start is blurred as much as boxes allow for, rays through a square near its
/// rim still hit; from farther they hit nothing.
TEST(FarEyes, SeeUntilTheirRaysAreTooBlurred) {
    const Tracer tracer(ShapeBuilder().face({rectangle(0, 1, 0, 1, 0)}).model());
    Random random(8);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 target(uniform(random, 0, 1), i % 2 == 0 ? 1e-6 : uniform(random, 0, 1), 0);
        Vec3 direction = random_direction(random);
        if (!(std::abs(direction.z) > 0.3)) continue;
        const double way = i % 3 == 0 ? 1.5e8 : uniform(random, 1, 1e8);
        const Vec3 origin = target - direction * way;
        const long double t = -static_cast<long double>(origin.z) / direction.z;
        const auto x = static_cast<double>(origin.x + t * direction.x);
        const auto y = static_cast<double>(origin.y + t * direction.y);
        const double blur = 1e-15 * way;
        const bool inside = x > blur && x < 1 - blur && y > blur && y < 1 - blur;
        EXPECT_TRUE(!inside || tracer.any(ray_through(origin, direction))) << i;
        EXPECT_FALSE(tracer.any(ray_through(target - direction * 1e9, direction))) << i;
    }
}

} // namespace
} // namespace keiko
