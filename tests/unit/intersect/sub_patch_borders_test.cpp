#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

bool is_flagged(const std::vector<Hit>& hits) {
    return std::any_of(hits.begin(), hits.end(),
                       [](const Hit& hit) { return has(hit.flags, HitFlags::tangential); });
}

/// Leaves of a sphere end at multiples of 1/16 of its patches, large ones beside small ones, and
/// reach over each other by 1e-11 of their own size.
TEST(SubPatchBorders, OfSubPatchesOfDifferentSizeAreHitOnce) {
    const Vec3 center(3, 4, 5);
    const SurfaceModel model = ShapeBuilder().face(sphere(center, 1)).model();
    for (const bool clipping_only : {false, true}) {
        const Tracer tracer(model, {.clipping_only = clipping_only});
        Random random(61);
        for (int i = 0; i < (clipping_only ? 2000 : 20000); ++i) {
            const double off = std::pow(10, -uniform(random, 11, 13)) * (i % 2 == 0 ? 1 : -1);
            Vec2 uv(std::floor(uniform(random, 1, 16)) / 16 + off, uniform(random, 0, 1));
            if (i % 4 > 1) std::swap(uv.x, uv.y);
            const Vec3 target =
                evaluate(model.patch(static_cast<std::uint32_t>(i % 8)), uv, 0).position();
            Vec3 direction = random_direction(random);
            if (std::abs(direction.dot(target - center)) < 0.1) continue;
            EXPECT_EQ(tracer.all(ray_through(target - direction * 5, direction)).size(), 2u) << i;
        }
    }
}

/// Rays that run along a border of sub-patches just below the surface come in and go out, however
/// near to each other, or say that they touch.
TEST(SubPatchBorders, AreEnteredAndLeftByRaysThatGrazeThem) {
    for (const double away : {0.0, 1e3, 1e6}) {
        const Vec3 center(away, -away, away);
        const SurfaceModel model = ShapeBuilder().face(sphere(center, 1)).model();
        for (const bool clipping_only : {false, true}) {
            const Tracer tracer(model, {.clipping_only = clipping_only});
            Random random(62);
            for (int i = 0; i < (clipping_only ? 1000 : 10000); ++i) {
                Vec2 uv(std::floor(uniform(random, 0, 9)) / 8, uniform(random, 0, 1));
                const bool along_u = i % 2 == 0;
                if (along_u) std::swap(uv.x, uv.y);
                const SurfaceDerivatives s =
                    evaluate(model.patch(static_cast<std::uint32_t>(i % 8)), uv, 1);
                const Vec3 out = (s.position() - center).normalized();
                const Vec3 tangent = along_u ? s.du() : s.dv();
                if (!(tangent.length() > 1e-6)) continue;
                const Vec3 along = (tangent - out * out.dot(tangent)).normalized();
                const Vec3 direction =
                    along + out.cross(along) * std::pow(10, -uniform(random, 3, 9));
                const double depth = std::pow(10, -uniform(random, 8, 16));
                const std::vector<Hit> hits =
                    tracer.all(ray_through(center + out * (1 - depth) - direction * 3, direction));
                EXPECT_TRUE(hits.size() % 2 == 0 || is_flagged(hits))
                    << away << ' ' << clipping_only << ' ' << i;
            }
        }
    }
}

} // namespace
} // namespace keiko
