#include "tests/support/exact_hits.h"
#include "tests/support/random_surfaces.h"
#include "tests/support/ray_class.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Straight through and beside the pole where four octants of a sphere collapse, and aslant.
TEST(Poles, AreHitOnceOnEachSide) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 10)).model());
    const Tracer clipping(ShapeBuilder().face(sphere(Vec3(0), 10)).model(),
                          {.clipping_only = true});
    Random random(71);
    for (int k = 0; k <= 17; ++k)
        for (int i = 0; i < 200; ++i) {
            const double off = k == 17 ? 0 : std::pow(10, -k);
            const double turn = uniform(random, 0, 2 * std::numbers::pi);
            const Vec3 at(off * std::cos(turn), off * std::sin(turn), 10);
            const Vec3 tilt = random_direction(random) * 0.7;
            const Vec3 direction(tilt.x, tilt.y, i % 5 == 0 ? -1 : -1 - std::abs(tilt.z));
            const Ray ray = ray_through(at - direction * 30, direction);
            for (const Tracer* each : {&tracer, &clipping})
                EXPECT_EQ(each->all(ray).size(), 2u) << off << ", " << exact_text(ray);
        }
}

/// 7e-11 mm off the pole: one sub-patch proves the root, its neighbour's clipping ends at it
/// unproved.
TEST(Poles, AreHitOnceWhereClippingEndsBesideAProof) {
    const Tracer tracer(ShapeBuilder().face(sphere(Vec3(0), 10)).model());
    const Ray ray =
        ray_through(Vec3(-0x1.5c338c77a16eep+3, 0x1.fac5624ac58d8p+3, 0x1.83c9ac0f3093dp+5),
                    Vec3(0x1.736a2f6e7fa9fp-2, -0x1.0e47235b1932p-1, -0x1.484e956589263p+0));
    EXPECT_EQ(tracer.all(ray).size(), 2u);
}

/// A bicubic patch with one side in a point, seen from above: hit once wherever the plan view of
/// its triangle says, the point itself included.
TEST(CollapsedEdges, AreHitOnce) {
    PatchData fan{3, 3, {}, {}, {}};
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) {
            const double r = 10.0 * i / 3, across = r * (j / 3.0 - 0.5);
            fan.points.emplace_back(r, across, 0.1 * r * r * (1 + 0.1 * j), 1);
        }
    const SurfaceModel model = ShapeBuilder().face({fan}).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    Random random(72);
    for (int i = 0; i < 3000; ++i) {
        const double x =
            i % 2 == 0 ? std::pow(10, uniform(random, -15, 1)) : uniform(random, 0, 10);
        const double share = uniform(random, -0.6, 0.6);
        if (std::abs(std::abs(share) - 0.5) < 1e-6 || x > 9.999999) continue;
        const Ray ray = ray_through(Vec3(x, share * x, 50), Vec3(0, 0, -1));
        for (const Tracer* each : {&tracer, &clipping}) {
            const std::size_t hits = each->all(ray).size();
            if (x > 1e-10) {
                EXPECT_EQ(hits, std::abs(share) < 0.5 ? 1u : 0u) << x << ' ' << share;
            } else {
                EXPECT_LE(hits, 1u) << x << ' ' << share; // within the sub-patch's own overlap
            }
        }
    }
    EXPECT_EQ(tracer.all(ray_through(Vec3(0, 0, 50), Vec3(0, 0, -1))).size(), 1u);
}

/// A flat patch stays flat whatever its weights: only the parameters move.
TEST(Weights, FromAThousandthToAThousandMoveNoPlane) {
    Random random(73);
    for (int degree = 1; degree <= 5; ++degree) {
        PatchData plane{degree, degree, {}, {}, {}};
        for (int i = 0; i <= degree; ++i)
            for (int j = 0; j <= degree; ++j) {
                const double w = std::pow(10, 3 * uniform(random, -1, 1));
                plane.points.emplace_back(100.0 * i / degree * w, 100.0 * j / degree * w, 7 * w, w);
            }
        const SurfaceModel model = ShapeBuilder().face({plane}).model();
        const Tracer tracer(model), clipping(model, {.clipping_only = true});
        for (int i = 0; i < 500; ++i) {
            const Vec3 target(uniform(random, 0, 100), uniform(random, 0, 100), 7);
            Vec3 from = target + random_direction(random) * 100;
            from.z = 107;
            const Ray ray = ray_through(from, target - from);
            for (const Tracer* each : {&tracer, &clipping}) {
                const std::vector<Hit> hits = each->all(ray);
                ASSERT_EQ(hits.size(), 1u) << degree << ' ' << exact_text(ray);
                EXPECT_LE((hits[0].position - target).length(), hits[0].position_bound + 1e-13);
            }
        }
    }
}

/// Strips of 1 : 1e4, curved along and across, straight and skewed.
TEST(Slivers, OfOneToTenThousandAreHit) {
    Random random(74);
    for (int k = 0; k < 20; ++k) {
        const SurfaceKind kind{
            .degree_u = 1 + k % 3, .degree_v = 3, .rough = 0.001, .length_u = 0.01};
        NurbsSurface surface = random_nurbs(random, kind);
        for (std::size_t i = 0; i < surface.points.size(); ++i)
            surface.points[i].z += surface.points[i].y * surface.points[i].y / 100; // bent along
        const SurfaceModel model = ShapeBuilder().face(patches_of(surface)).model();
        const Tracer tracer(model), clipping(model, {.clipping_only = true});
        const ExactPatch exact(model.patch(0));
        for (int i = 0; i < 500; ++i) {
            const Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
            const Vec3 target = shortened(exact.at(uv.x, uv.y).position);
            const Vec3 direction = random_direction(random);
            const Ray ray = ray_through(target - direction * 300, direction);
            const auto root = exact_root(exact, ray, uv);
            if (!root || !root->on_patch()) continue;
            for (const Tracer* each : {&tracer, &clipping})
                EXPECT_TRUE(among(each->all(ray), *root)) << k << ' ' << exact_text(ray);
        }
    }
}

} // namespace
} // namespace keiko
