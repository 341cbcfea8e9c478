#include "tests/support/brute_force.h"
#include "tests/support/exact_hits.h"
#include "tests/support/random_surfaces.h"
#include "tests/support/ray_class.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Rays through random points of a model's patches: the point is among the hits of both modes.
void expect_all_found(const SurfaceModel& model, Random& random, int rays) {
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (int i = 0; i < rays; ++i) {
        const auto patch = static_cast<std::uint32_t>(pick(random, model.patches.size()));
        const ExactPatch exact(model.patch(patch));
        const Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
        const Vec3 direction = random_direction(random);
        const Ray ray =
            ray_through(shortened(exact.at(uv.x, uv.y).position) - direction * 300, direction);
        const auto root = exact_root(exact, ray, uv);
        if (!root || !root->on_patch()) continue;
        EXPECT_TRUE(among(tracer.all(ray), *root)) << i << ' ' << exact_text(ray);
        if (i % 8 == 0) {
            EXPECT_TRUE(among(clipping.all(ray), *root)) << i << ' ' << exact_text(ray);
        }
    }
}

class Degrees : public testing::TestWithParam<int> {};

TEST_P(Degrees, AreTracedPolynomialAndRational) {
    Random random(91);
    for (const double weights : {1.0, 4.0})
        for (const int other : {1, 2, GetParam()}) {
            const SurfaceKind kind{
                .degree_u = GetParam(), .degree_v = other, .rough = 15, .weights = weights};
            expect_all_found(random_face(random, kind), random, 150);
        }
}

INSTANTIATE_TEST_SUITE_P(, Degrees,
                         testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 25));

/// Inner knots as often as the degree make creases; once more, and the sheet is torn there.
TEST(FullMultiplicityKnots, LoseNoHitAtCreasesAndTears) {
    Random random(92);
    for (int degree = 1; degree <= 6; ++degree)
        for (const int times : {degree, degree + 1}) {
            NurbsSurface surface{degree, 2, {}, {0, 0, 0, 1, 1, 1}, {}};
            for (const double knot : {0.0, 0.4, 0.7, 1.0}) {
                const bool end = knot == 0 || knot == 1;
                surface.knots_u.insert(surface.knots_u.end(),
                                       static_cast<std::size_t>(end ? degree + 1 : times), knot);
            }
            for (std::size_t i = 0; i < surface.count_u(); ++i)
                for (int j = 0; j < 3; ++j)
                    surface.points.emplace_back(10.0 * static_cast<double>(i), 20.0 * j,
                                                uniform(random, -15, 15), 1);
            const SurfaceModel model = ShapeBuilder().face(patches_of(surface)).model();
            ASSERT_EQ(model.patches.size(), 3u);
            expect_all_found(model, random, 500);
        }
}

/// Rays at the inner edges and corners of a smooth sheet of 4 x 4 spans go through it once, as the
/// sheet is a graph over the plane seen from above.
TEST(SpanEdges, AndCornersAreHitOnce) {
    Random random(93);
    for (const double weights : {1.0, 8.0}) {
        const SurfaceKind kind{.degree_u = 3,
                               .degree_v = 2,
                               .spans_u = 4,
                               .spans_v = 4,
                               .rough = 0,
                               .weights = weights};
        NurbsSurface surface = random_nurbs(random, kind);
        for (Vec4& p : surface.points) p.z += p.w * uniform(random, -5, 5);
        const SurfaceModel model = ShapeBuilder().face(patches_of(surface)).model();
        const Tracer tracer(model), clipping(model, {.clipping_only = true});
        for (int i = 0; i < 6000; ++i) {
            const auto patch = static_cast<std::uint32_t>(pick(random, model.patches.size()));
            Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
            uv.x = i % 3 == 0 ? uv.x : static_cast<double>(i % 2);
            uv.y = i % 3 == 1 ? uv.y : static_cast<double>(i / 2 % 2);
            const Vec2 place = model.face_parameters(patch, uv);
            if (!Box2{Vec2(0), Vec2(1)}.padded(-1e-6).contains(place)) continue; // outer border
            const Vec3 target = evaluate(model.patch(patch), uv, 0).position();
            const Ray ray = ray_through(target + Vec3(0, 0, 100), Vec3(0, 0, -1));
            for (const Tracer* each : {&tracer, &clipping}) {
                const std::vector<Hit> hits = each->all(ray);
                ASSERT_EQ(hits.size(), 1u) << weights << ' ' << i << ' ' << exact_text(ray);
                EXPECT_LE((hits[0].position - target).length(), hits[0].position_bound + 1e-12);
            }
        }
    }
}

} // namespace
} // namespace keiko
