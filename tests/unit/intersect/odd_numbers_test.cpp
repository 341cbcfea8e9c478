#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

using namespace test;

constexpr double denormal = std::numeric_limits<double>::denorm_min();
constexpr double tiny = std::numeric_limits<double>::min();

/// Six flat sides of the cube [0, 10]^3.
SurfaceModel cube() {
    const auto side = [](const Vec3& o, const Vec3& u, const Vec3& v) {
        return bilinear(o, o + u, o + v, o + u + v);
    };
    const Vec3 x(10, 0, 0), y(0, 10, 0), z(0, 0, 10), zero(0);
    ShapeBuilder builder;
    builder.face({side(zero, x, y)}).face({side(z, x, y)}).face({side(zero, x, z)});
    builder.face({side(y, x, z)}).face({side(zero, y, z)}).face({side(x, y, z)});
    return builder.model();
}

/// Along each axis both ways, its zero components of either sign, through faces, edges and corners.
TEST(AxisParallelRays, GoThroughACubeWithZerosOfEitherSign) {
    const Tracer tracer(cube());
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const double way : {1.0, -1.0})
            for (const double zero : {0.0, -0.0})
                for (const double a : {0.0, -0.0, 3.0, 5.0, 10.0})
                    for (const double b : {0.0, 2.5, 10.0}) {
                        Ray ray = ray_through(Vec3(0), Vec3(zero));
                        ray.direction[axis] = way;
                        ray.origin[axis] = way > 0 ? -7 : 17;
                        ray.origin[(axis + 1) % 3] = a;
                        ray.origin[(axis + 2) % 3] = b;
                        const std::vector<Hit> hits = tracer.all(ray);
                        ASSERT_GE(hits.size(), 2u) << axis << way << ' ' << a << ' ' << b;
                        EXPECT_NEAR(hits.front().t, 7, 1e-9);
                        EXPECT_NEAR(hits.back().t, 17, 1e-9);
                    }
}

/// Nearly parallel rays of one packet. Some miss the ball around the scene: those have no
/// start in it, and no processor may trace them.
TEST(CoherentPackets, HoldRaysThatMissTheScene) {
    const Tracer tracer(cube());
    std::vector<Ray> rays;
    for (int i = 0; i < 64; ++i)
        rays.push_back(ray_through(Vec3(4.0 + 0.5 * (i % 16), 4, -700), Vec3(1e-3 * i, 0, 1)));
    const auto hits = tracer.nearest(rays);
    std::size_t met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(hits[i].has_value(), tracer.nearest(rays[i]).has_value()) << i;
        met += hits[i].has_value();
    }
    EXPECT_GT(met, 3U);
    EXPECT_LT(met, 32U);
}

/// Components too small to move a ray by anything change nothing, and raise no fuss.
TEST(Denormals, InARayAreAsGoodAsZero) {
    const Tracer tracer(ShapeBuilder().face({rectangle(0, 10, 0, 20, 5)}).model());
    for (const double small : {denormal, -denormal, 100 * denormal, tiny, -tiny}) {
        for (const Ray& ray : {ray_through(Vec3(3, 7, 40), Vec3(small, -small, -2)),
                               ray_through(Vec3(small, 7, 40), Vec3(0, 0, -2)),
                               ray_through(Vec3(3, 7, 40), Vec3(0, 0, -2), small)}) {
            const auto hit = tracer.nearest(ray);
            ASSERT_TRUE(hit || ray.origin.x < 0) << small;
            if (hit) {
                EXPECT_DOUBLE_EQ(hit->t, 17.5);
            }
        }
    }
}

/// A direction that is denormal as a whole has no length that could be computed: it may hit or
/// miss, but what it hits is right.
TEST(Denormals, AsAWholeDirectionDoNoHarm) {
    const Tracer tracer(ShapeBuilder().face({rectangle(0, 10, 0, 20, 5)}).model());
    for (const double scale : {denormal, 1e-320, tiny, 1e-200, 1e-100, 1e100, 1e150, 1e200}) {
        const auto hit = tracer.nearest(ray_through(Vec3(3, 7, 40), Vec3(0, 0, -scale)));
        if (scale >= 1e-100 && scale <= 1e150) {
            ASSERT_TRUE(hit) << scale;
        }
        if (!hit) continue;
        EXPECT_LE((hit->position - Vec3(3, 7, 5)).length(), hit->position_bound) << scale;
        EXPECT_NEAR(hit->t * scale, 35, 1e-12);
    }
}

TEST(Denormals, InControlPointsAreAsGoodAsZero) {
    Random random(101);
    PatchData patch = random_patch(random, 3, 3, 10, 1);
    PatchData rough = patch;
    for (Vec4& p : patch.points) p.y = std::abs(p.y) < 30 ? 0 : p.y;
    for (std::size_t i = 0; i < rough.points.size(); ++i)
        rough.points[i].y = patch.points[i].y == 0 ? denormal : patch.points[i].y;
    const Tracer plain(ShapeBuilder().face({patch}).model());
    const Tracer denormals(ShapeBuilder().face({rough}).model());
    for (int i = 0; i < 2000; ++i) {
        const Vec3 target(uniform(random, -60, 60), uniform(random, -60, 60), 0);
        const Vec3 eye = random_direction(random) * 200;
        const auto a = plain.all(ray_through(eye, target - eye));
        const auto b = denormals.all(ray_through(eye, target - eye));
        ASSERT_EQ(a.size(), b.size()) << i;
        for (std::size_t k = 0; k < a.size(); ++k)
            EXPECT_LE((a[k].position - b[k].position).length(),
                      a[k].position_bound + b[k].position_bound);
    }
}

} // namespace
} // namespace keiko
