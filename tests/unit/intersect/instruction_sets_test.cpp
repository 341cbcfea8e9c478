#include "tests/support/instruction_sets.h"

#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_surfaces.h"
#include "tests/support/ray_class.h"
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace keiko {
namespace {

using namespace test;

SurfaceModel sheets() {
    Random random(201);
    ShapeBuilder builder;
    for (int i = 0; i < 6; ++i)
        builder.face({random_patch(random, 1 + i, 3, 15, 1 + i % 3, Vec3(0, 0, 30.0 * i))});
    builder.face(sphere(Vec3(0, 0, -60), 40));
    return builder.model();
}

std::vector<Ray> rays() {
    Random random(202);
    std::vector<Ray> all;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a(uniform(random, -60, 60), uniform(random, -60, 60),
                     uniform(random, -110, 180));
        const Vec3 b(uniform(random, -60, 60), uniform(random, -60, 60),
                     uniform(random, -110, 180));
        all.push_back(ray_through(a + (a - b).normalized() * 300, b - a));
    }
    // And coherent ones, for packets.
    for (int i = 0; i < 4096; ++i) {
        const Vec3 eye(20, -300, 260), target(-60 + i % 64 * 1.9, -60 + i / 64 * 1.9, 0);
        all.push_back(ray_through(eye, target - eye));
    }
    return all;
}

TEST(InstructionSets, AreSeveral) {
    std::set<std::string> names;
    for (const std::int64_t set : instruction_sets()) {
        const WithInstructionSet only(set);
        names.insert(Tracer(ShapeBuilder().face({rectangle(0, 1, 0, 1, 0)}).model())
                         .statistics()
                         .instruction_set);
    }
    EXPECT_EQ(names.size(), instruction_sets().size());
    EXPECT_GE(names.size(), 2u);
}

/// Fused or not, wide or narrow: the hits are the same to within the bounds they state.
TEST(InstructionSets, AgreeWithinTheirBounds) {
    const SurfaceModel model = sheets();
    const std::vector<Ray> all = rays();
    const std::vector<std::vector<Hit>> expected = Tracer(model).all(all);
    for (const std::int64_t set : instruction_sets()) {
        const WithInstructionSet only(set);
        const Tracer tracer(model);
        SCOPED_TRACE(tracer.statistics().instruction_set);
        const std::vector<std::vector<Hit>> hits = tracer.all(all);
        for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(hits[i].size(), expected[i].size()) << i;
            for (std::size_t k = 0; k < hits[i].size(); ++k) {
                const Hit &a = hits[i][k], &b = expected[i][k];
                EXPECT_EQ(a.face, b.face) << i;
                EXPECT_LE((a.position - b.position).length(), a.position_bound + b.position_bound)
                    << i;
            }
        }
    }
}

/// In packets, gathered or alone, a ray gets the same bits from one instruction set.
TEST(InstructionSets, GiveARayTheSameBitsInAnyCompany) {
    const SurfaceModel model = sheets();
    const std::vector<Ray> all = rays();
    for (const std::int64_t set : instruction_sets()) {
        const WithInstructionSet only(set);
        const Tracer tracer(model);
        SCOPED_TRACE(tracer.statistics().instruction_set);
        const std::vector<Crossing> together = tracer.nearest_crossings(all);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Crossing alone = tracer.nearest_crossings(std::span(&all[i], 1)).front();
            ASSERT_EQ(alone.sub_patch, together[i].sub_patch) << i;
            EXPECT_EQ(alone.t, together[i].t) << i;
            EXPECT_EQ(alone.uv, together[i].uv) << i;
            EXPECT_EQ(alone.error, together[i].error) << i;
        }
    }
}

/// Hits of one sub-patch are evaluated side by side where there are many: to the bits of one alone.
TEST(InstructionSets, EvaluateAHitToTheSameBitsInAnyCompany) {
    const SurfaceModel model = sheets();
    const std::vector<Ray> all = rays();
    for (const std::int64_t set : instruction_sets()) {
        const WithInstructionSet only(set);
        const Tracer tracer(model, {.second_derivatives = true});
        SCOPED_TRACE(tracer.statistics().instruction_set);
        const std::vector<std::optional<Hit>> together = tracer.nearest(all);
        int hits = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::optional<Hit> alone = tracer.nearest(std::span(&all[i], 1)).front();
            ASSERT_EQ(alone.has_value(), together[i].has_value()) << i;
            if (!alone) continue;
            ++hits;
            const Hit &a = *alone, &b = *together[i];
            EXPECT_EQ(a.position, b.position) << i;
            EXPECT_EQ(a.normal, b.normal) << i;
            EXPECT_EQ(a.dpdu, b.dpdu) << i;
            EXPECT_EQ(a.dpdv, b.dpdv) << i;
            EXPECT_EQ(a.second->duu, b.second->duu) << i;
            EXPECT_EQ(a.second->duv, b.second->duv) << i;
            EXPECT_EQ(a.second->dvv, b.second->dvv) << i;
            EXPECT_EQ(a.position_bound, b.position_bound) << i;
        }
        EXPECT_GT(hits, 4000);
    }
}

} // namespace
} // namespace keiko
