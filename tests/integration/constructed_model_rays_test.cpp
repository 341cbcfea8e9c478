#include "keiko/import/worker/load_model.h"

#include "tests/support/file_test_name.h"
#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/ray_tally.h"
#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

using namespace test;

class ConstructedModelRays : public testing::TestWithParam<const char*> {};

/// Test as ConstructedRays, through points of the models of surfaces/.
TEST_P(ConstructedModelRays, FindTheirPointAmongAllHits) {
    const RayScene scene(load_model(repository("surfaces") / GetParam()));
    const std::size_t count = ray_count(20'000, 2'000'000);
    RayTally tally(GetParam());
    const std::uint64_t seed = first_seed();
    Random random(seed);
    for (std::size_t i = 0; tally.rays() < count && i < 10 * count; ++i) {
        const auto aimed = scene.aim(random, ray_classes[i % ray_classes.size()]);
        const std::string label = "seed " + std::to_string(seed) + ", ray " + std::to_string(i);
        if (!aimed) {
            tally.add_unmade();
            continue;
        }
        tally.add(scene, *aimed, scene.judge(*aimed), label);
        if (i % 500 == 0)
            tally.add_brute_force(aimed->ray, scene.judge_by_brute_force(aimed->ray), label);
    }
    tally.expect_none_lost();
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ConstructedModelRays,
                         testing::Values("concept-car.step", "hood.step", "rational-sphere.step",
                                         "pole.step", "dent.step", "trimmed-hole.step",
                                         "trimmed-two-holes.step", "trimmed-island.step",
                                         "seam-g0-gap.step", "seam-g1-angle.step", "saddle.bpt",
                                         "dome.bpt"),
                         test::file_test_name);

} // namespace
} // namespace keiko
