#include "keiko/intersect/hit/reflect_ray.h"

#include "tests/support/instruction_sets.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace keiko;

namespace {

Vec3 random_vector(test::Random& random) {
    return test::random_direction(random) * std::pow(10, test::uniform(random, -2, 3));
}

/// A ray at some place of some surface. Of `kind` 0 to 4: a plain one, one at a pole, one along
/// the surface, one without differentials, one at a surface without second derivatives.
struct Case {
    Ray ray;
    Hit hit;

    Case(test::Random& random, std::size_t kind) {
        ray.origin = random_vector(random);
        ray.direction = test::random_direction(random) * test::uniform(random, 0.5, 2);
        if (kind != 3)
            ray.differentials = RayDifferentials{random_vector(random), random_vector(random),
                                                 random_vector(random), random_vector(random)};
        hit.t = test::uniform(random, 0, 1000);
        hit.position = ray.at(hit.t);
        hit.dpdu = random_vector(random), hit.dpdv = random_vector(random);
        if (kind == 1) hit.dpdv = hit.dpdu * test::uniform(random, 0, 1) + Vec3(1e-9);
        if (kind == 1 && hit.t < 300) hit.dpdu = hit.dpdv = Vec3(0);
        hit.normal = hit.dpdu.cross(hit.dpdv).normalized();
        if (hit.t < 500) hit.normal = -hit.normal;
        if (kind == 2) hit.normal = Vec3(0, 0, 1), ray.direction = Vec3(1, 0, 0);
        if (kind != 4)
            hit.second = SecondDerivatives{random_vector(random), random_vector(random),
                                           random_vector(random)};
        hit.root = {1, static_cast<std::uint32_t>(kind), {{0.25, 0.5}, {0.25, 0.5}}};
    }
};

void expect_same(const Ray& is, const Ray& alone) {
    EXPECT_EQ(is.origin, alone.origin);
    EXPECT_EQ(is.direction, alone.direction);
    EXPECT_EQ(is.t_max, alone.t_max);
    ASSERT_TRUE(is.excluded);
    EXPECT_EQ(is.excluded->patch, alone.excluded->patch);
    EXPECT_EQ(is.excluded->uv, alone.excluded->uv);
    ASSERT_EQ(is.differentials.has_value(), alone.differentials.has_value());
    if (!is.differentials) return;
    EXPECT_EQ(is.differentials->origin_dx, alone.differentials->origin_dx);
    EXPECT_EQ(is.differentials->origin_dy, alone.differentials->origin_dy);
    EXPECT_EQ(is.differentials->direction_dx, alone.differentials->direction_dx);
    EXPECT_EQ(is.differentials->direction_dy, alone.differentials->direction_dy);
}

} // namespace

TEST(ReflectionBatch, GivesEachRayTheBitsThatItHasAlone) {
    test::Random random(4);
    std::vector<Case> cases;
    for (std::size_t i = 0; i < 1003; ++i) cases.emplace_back(random, i % 7);
    std::size_t with_differentials = 0;
    for (const std::int64_t set : test::instruction_sets()) {
        const test::WithInstructionSet only(set);
        std::vector<Ray> mirrored(cases.size());
        ReflectionBatch mirroring(reflection_kernel());
        for (std::size_t i = 0; i < cases.size(); ++i)
            mirroring.add(cases[i].ray, cases[i].hit, mirrored[i]);
        mirroring.finish();
        for (std::size_t i = 0; i < cases.size(); ++i) {
            SCOPED_TRACE(i);
            ASSERT_NO_FATAL_FAILURE(
                expect_same(mirrored[i], reflect_ray(cases[i].ray, cases[i].hit)));
            with_differentials += mirrored[i].differentials.has_value();
        }
    }
    EXPECT_GT(with_differentials, 400u);
}
