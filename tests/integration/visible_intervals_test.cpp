#include "keiko/import/worker/load_model.h"

#include "tests/support/file_test_name.h"
#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/visibility_probe.h"
#include <gtest/gtest.h>

#include <iostream>

namespace keiko {
namespace {

using namespace test;
using From = VisibilityProbe::From;

/// Looks out from many viewpoints and holds every segment against single rays.
void expect_intervals_as_probed(const std::filesystem::path& file) {
    const VisibilityProbe probe(load_model(file));
    constexpr int lamps = 6, probes = 24;
    const std::size_t looks = ray_count(60, 20'000);
    Random random(5);
    ProbeCounts counts;
    for (const From from : {From::surface, From::space, From::infinity})
        for (std::size_t i = 0; i < looks; ++i) probe.look(from, lamps, probes, random, counts);
    std::cout << file.filename().string() << ": " << counts.text() << "\n";
    EXPECT_GT(counts.partly_hidden, counts.segments / 50);
    EXPECT_EQ(counts.wrong_segments, 0u);
}

class VisibleIntervalsOfFixtures : public testing::TestWithParam<const char*> {};

TEST_P(VisibleIntervalsOfFixtures, AreAsDenselyProbed) {
    expect_intervals_as_probed(repository("surfaces") / GetParam());
}

INSTANTIATE_TEST_SUITE_P(, VisibleIntervalsOfFixtures,
                         testing::Values("concept-car.step", "hood.step", "dome.bpt", "saddle.bpt",
                                         "dent.step", "pole.step", "rational-sphere.step",
                                         "trimmed-hole.step", "trimmed-island.step",
                                         "trimmed-two-holes.step", "cage-cube.obj",
                                         "seam-g1-angle.step"),
                         test::file_test_name);

class VisibleIntervalsOfRealModels : public testing::TestWithParam<const char*> {};

TEST_P(VisibleIntervalsOfRealModels, AreAsDenselyProbed) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    expect_intervals_as_probed(shared_model(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(, VisibleIntervalsOfRealModels,
                         testing::Values("newell-teapot.bpt", "car-hood.brep", "linkrods.step",
                                         "bspline-sphere-degree-10.brep",
                                         "bspline-cylinder-degree-13.brep", "torus.brep",
                                         "ship-propeller-and-shaft.igs", "screw.step"),
                         test::file_test_name);

} // namespace
} // namespace keiko
