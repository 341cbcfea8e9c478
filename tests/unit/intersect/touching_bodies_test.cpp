#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <numbers>

using namespace keiko;
using namespace keiko::test;

namespace {

/// A plate of 100 mm in z = 0, and the same again, placed otherwise.
SurfaceModel two_plates(const Affine& second) {
    ModelBuilder builder;
    builder.plane({-50, -50, 0}, {100, 0, 0}, {0, 100, 0});
    builder.instance({});
    builder.instance(second);
    return builder.build();
}

/// From the place where `down` meets the first of two bodies, upwards.
bool stopped(const Tracer& tracer, const Vec3& place, const Vec3& way) {
    Ray down;
    down.origin = place + Vec3(0, 0, 10);
    down.direction = {0, 0, -1};
    for (const Hit& hit : tracer.all(down)) {
        if (hit.instance != 0) continue;
        Ray up;
        up.origin = hit.position;
        up.excluded = hit.root;
        up.direction = way;
        return tracer.any(up);
    }
    ADD_FAILURE() << "nothing below";
    return true;
}

} // namespace

// Sheets flush with each other, walls that stand on a floor: rays leave where both begin.
TEST(TouchingBodies, DoNotStopRaysWhereTheyTouch) {
    Random random(3);
    const Tracer flush(two_plates({}));
    const Affine upright = Affine::rotate({0, 1, 0}, std::numbers::pi / 2);
    const Tracer wall(two_plates(Affine::translate({10, 0, 50}) * upright));
    for (int i = 0; i < 200; ++i) {
        const double y = uniform(random, -40, 40), x = uniform(random, -40, 40);
        EXPECT_FALSE(stopped(flush, {x, y, 0}, {uniform(random, -1, 1), 0, 1}));
        EXPECT_FALSE(stopped(wall, {10, y, 0}, {uniform(random, -3, -0.01), 0.2, 1}));
        EXPECT_TRUE(stopped(wall, {9.99, y, 0}, {0.1, 0, 1}));
    }
}

TEST(TouchingBodies, StopRaysFromNextToNothingBelowThem) {
    for (const double gap : {1e-6, 1e-9}) {
        const Tracer above(two_plates(Affine::translate({0, 0, gap})));
        EXPECT_TRUE(stopped(above, {3, 4, 0}, {0.3, 0.1, 1})) << gap;
    }
}

// A small ball on a floor of 100 m: roots are only as exact as the whole scene is wide.
TEST(TouchingBodies, RaysFromSeamsOfSmallBodiesInWideScenesAreFree) {
    Random random(5);
    for (const double radius : {0.1, 1.0, 10.0}) {
        ModelBuilder builder;
        const double s = std::numbers::sqrt2 / 2, r = radius;
        builder.nurbs(revolution(2, {0, 0, 0, 1, 1, 2, 2, 2},
                                 {{0, 0, -r, 1},
                                  {r * s, 0, -r * s, s},
                                  {r, 0, 0, 1},
                                  {r * s, 0, r * s, s},
                                  {0, 0, r, 1}}));
        builder.plane({-1e5, -1e5, -2 * r}, {2e5, 0, 0}, {0, 2e5, 0});
        const Tracer tracer(builder.build());
        for (int i = 0; i < 300; ++i) {
            const double angle = uniform(random, 0, 2 * std::numbers::pi);
            const Vec3 out(std::cos(angle), std::sin(angle), 0);
            Ray in;
            in.origin = out * (3 * r);
            in.direction = -out;
            const auto hit = tracer.nearest(in);
            ASSERT_TRUE(hit);
            Ray away;
            away.origin = hit->position;
            away.excluded = hit->root;
            away.direction = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), 1);
            if (away.direction.dot(out) < 0.02) continue;
            EXPECT_FALSE(tracer.any(away)) << radius << ' ' << angle;
        }
    }
}
