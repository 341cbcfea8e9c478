#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// A face whose trim loop runs along its patch's own ends, with an edge of some tolerance.
SurfaceModel bordered(const PatchData& patch, double tolerance) {
    ShapeBuilder builder;
    const std::uint32_t edge = builder.edge(tolerance);
    builder.face({patch}, {polygon({Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}, edge)});
    return builder.model();
}

/// Beyond its end a rational patch runs away, or has no weight at all: going on there for the sake
/// of a seam must not cost hits on it.
TEST(RationalBorders, KeepTheirHitsWhateverTheTolerance) {
    Random random(221);
    for (const int degree : {1, 2, 3})
        for (const double weights : {1e2, 1e3, 1e6})
            for (const double tolerance : {0.0, 1e-3, 0.1, 0.5}) {
                PatchData patch = random_patch(random, degree, 2, 3, 1);
                for (std::size_t i = 0; i < patch.points.size(); ++i) {
                    const double share = static_cast<double>(i / 3) / degree;
                    patch.points[i] *= std::pow(weights, share);
                }
                const SurfaceModel model = bordered(patch, tolerance);
                const Tracer tracer(model);
                int lost = 0;
                for (int k = 0; k < 300; ++k) {
                    const Vec2 uv(uniform(random, 0.001, 0.999), uniform(random, 0.001, 0.999));
                    const Vec3 target = evaluate(model.patch(0), uv, 0).position();
                    const Vec3 eye = target + Vec3(uniform(random, -30, 30), 10, 100);
                    const auto hits = tracer.all(ray_through(eye, target - eye));
                    lost += std::none_of(hits.begin(), hits.end(), [&](const Hit& hit) {
                        return (hit.position - target).length() < 1e-6;
                    });
                }
                EXPECT_EQ(lost, 0) << degree << ' ' << weights << ' ' << tolerance;
            }
}

/// Two sheets that overlap, or gape, by less than their edge's tolerance.
TEST(NearestHits, AreTheFirstOfAll) {
    Random random(222);
    for (const double gap : {-2e-3, 0.0, 2e-3}) {
        ShapeBuilder builder;
        const std::uint32_t edge = builder.edge(5e-3);
        for (const double side : {-1.0, 1.0}) {
            const double inner = side * gap / 2, outer = side * 10;
            builder.face({bilinear(Vec3(inner, -10, 0), Vec3(outer, -10, 3), Vec3(inner, 10, 0),
                                   Vec3(outer, 10, 4))},
                         {polygon({Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}, edge)});
        }
        const Tracer tracer(builder.model());
        for (int i = 0; i < 20000; ++i) {
            const Vec3 target(uniform(random, -0.01, 0.01), uniform(random, -9, 9), 0);
            // Steep enough that no ray crosses both sheets within their tolerance.
            const Vec3 eye = target + Vec3(uniform(random, -5, 5), uniform(random, -5, 5), 30);
            const Ray ray = ray_through(eye, target - eye);
            const auto nearest = tracer.nearest(ray);
            const auto all = tracer.all(ray);
            ASSERT_EQ(nearest.has_value(), !all.empty()) << i;
            EXPECT_EQ(tracer.any(ray), !all.empty()) << i;
            if (!nearest) continue;
            EXPECT_LE((nearest->position - all.front().position).length(),
                      nearest->position_bound + all.front().position_bound + 1e-2)
                << i;
            // Where two sheets overlap or touch either is true.
            if (gap > 0) {
                EXPECT_EQ(nearest->face, all.front().face) << i << ' ' << gap;
            }
        }
    }
}

/// Placements need not keep angles.
TEST(Placements, MayShearAndScale) {
    Random random(223);
    const PatchData patch = random_patch(random, 3, 3, 12, 2);
    Affine sheared;
    sheared.rows = {Vec3(2, 0.7, -0.3), Vec3(-0.2, 0.1, 0.05), Vec3(0.4, -1.5, 3)};
    sheared.translation = Vec3(30, -200, 1000);
    Affine mirrored = sheared;
    mirrored.rows[1] = mirrored.rows[1] * -30;
    const SurfaceModel model = ShapeBuilder().face({patch}).place({sheared, mirrored}).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    int found = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 part(uniform(random, -55, 55), uniform(random, -55, 55), 0);
        const Vec3 target = (i % 2 == 0 ? sheared : mirrored).point(part);
        const Vec3 eye = target + random_direction(random) * 3000;
        const Ray ray = ray_through(eye, target - eye);
        const auto hits = tracer.all(ray), expected = clipping.all(ray);
        ASSERT_EQ(hits.size(), expected.size()) << i;
        for (std::size_t k = 0; k < hits.size(); ++k, ++found) {
            EXPECT_EQ(hits[k].instance, expected[k].instance);
            EXPECT_LE((hits[k].position - expected[k].position).length(),
                      hits[k].position_bound + expected[k].position_bound);
        }
    }
    EXPECT_GT(found, 4000);
}

TEST(Scenes, TooLargeForEmbreeAreRefused) {
    const SurfaceModel model = ShapeBuilder().face({rectangle(0, 1e19, 0, 1e19, 0)}).model();
    EXPECT_THROW(Tracer{model}, std::exception);
}

} // namespace
} // namespace keiko
