#include "tests/support/brute_force.h"

#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

using namespace test;

struct Kind {
    const char* name;
    int degree_u, degree_v;
    double rough, weights;
};

/// Every hit of the model's patches along the ray by brute force, nearest first.
std::vector<double> expected(const SurfaceModel& model, const Ray& ray) {
    std::vector<double> t;
    for (std::uint32_t p = 0; p < model.patches.size(); ++p)
        for (const Vec2& uv : brute_force_roots(model.patch(p), ray)) {
            const Vec3 to = evaluate(model.patch(p), uv, 0).position() - ray.origin;
            const double at = to.dot(ray.direction) / ray.direction.length2();
            if (at >= ray.t_min && at <= ray.t_max) t.push_back(at);
        }
    std::sort(t.begin(), t.end());
    return t;
}

class BruteForce : public testing::TestWithParam<Kind> {};

TEST_P(BruteForce, AgreesWithTracerOnEveryHit) {
    const Kind kind = GetParam();
    Random random(7);
    ShapeBuilder builder;
    for (int i = 0; i < 4; ++i)
        builder.face({random_patch(random, kind.degree_u, kind.degree_v, kind.rough, kind.weights,
                                   Vec3(0, 0, 20.0 * i))});
    const SurfaceModel& model = builder.model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});

    std::size_t hits = 0, folds = 0;
    for (int i = 0; i < 250; ++i) {
        const Vec3 target(uniform(random, -60, 60), uniform(random, -60, 60),
                          uniform(random, -10, 70));
        Ray ray = ray_through(random_direction(random) * 200, Vec3(0));
        ray.direction = target - ray.origin;
        const std::vector<double> t = expected(model, ray);
        for (const Tracer* each : {&tracer, &clipping}) {
            const std::vector<Hit> found = each->all(ray);
            ASSERT_EQ(found.size(), t.size()) << kind.name << ", ray " << i;
            for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(found[k].t, t[k], 1e-8);
            const std::optional<Hit> first = each->nearest(ray);
            ASSERT_EQ(first.has_value(), !t.empty());
            EXPECT_EQ(each->any(ray), !t.empty());
            if (first) {
                EXPECT_EQ(first->t, found.front().t);
            }
        }
        hits += t.size();
        folds += t.size() > 4;
    }
    // The scene must be one that asks something of the tracer.
    EXPECT_GT(hits, 150u);
    if (kind.rough > 50) {
        EXPECT_GT(folds, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Patches, BruteForce,
                         testing::Values(Kind{"Bicubic", 3, 3, 15, 1}, Kind{"Folded", 3, 3, 60, 1},
                                         Kind{"RationalBiquadratic", 2, 2, 20, 10},
                                         Kind{"WeightsThousandfold", 3, 2, 15, 1e3},
                                         Kind{"Bilinear", 1, 1, 30, 1},
                                         Kind{"QuinticByLinear", 5, 1, 20, 3},
                                         Kind{"DegreeEleven", 11, 11, 40, 1}),
                         [](const auto& kind) { return std::string(kind.param.name); });

} // namespace
} // namespace keiko
