#include "keiko/import/worker/load_model.h"

#include "tests/integration/closed_model.h"
#include "tests/integration/closed_shells.h"
#include "tests/support/file_test_name.h"
#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <iostream>

namespace keiko {
namespace {

using namespace test;

void expect_closed(const std::filesystem::path& file) {
    const ClosedModel model(load_model(file));
    const std::size_t count = ray_count(10'000, 1'000'000);
    Random random(first_seed());
    ClosureCounts counts;
    for (std::size_t i = 0; i < count; ++i) {
        model.count_parity(model.random_ray(random), counts);
        if (const auto point = model.random_edge_point(random))
            model.count_aimed(*point, random, counts);
    }
    std::cout << file.filename().string() << ": " << counts.text() << "\n";
    EXPECT_GT(counts.hits, counts.rays / 4);
    EXPECT_GT(counts.aimed, count / 2);
    // No odd number of hits may hide behind an outline.
    EXPECT_LE(counts.edge_on, counts.rays / 10'000);
    EXPECT_LE(counts.tangential, counts.rays / 1'000);
    EXPECT_EQ(counts.leaks, 0u);
    EXPECT_EQ(counts.doubled, 0u);
    EXPECT_LE(counts.through_steps, counts.rays / 100'000);
    EXPECT_EQ(counts.unclear, 0u);
    EXPECT_EQ(counts.out_of_order, 0u);
    EXPECT_EQ(counts.aimed_lost, 0u);
}

class ClosedSolids : public testing::TestWithParam<const char*> {};

TEST_P(ClosedSolids, AreLeftAsOftenAsEntered) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    const auto file = shared_model(GetParam());
    ASSERT_TRUE(closed_by_opencascade(file));
    expect_closed(file);
}

INSTANTIATE_TEST_SUITE_P(
    RealModels, ClosedSolids,
    testing::Values("assembly-as1-oc-214.step", "assembly-coloured-bolt-faces.step",
                    "box-with-nurbs-sphere.step", "bspline-cylinder-degree-13.brep",
                    "bspline-sphere-degree-10.brep", "cube-10x10-nurbs.igs", "cube-unit-in.step",
                    "cube-unit-mm.step", "die-cast-housing-degree-5.step", "extruder-drive.step",
                    "linkrods.step", "nist-pmi-2.step", "nist-pmi-6-inch.step",
                    "pump-bottom-degree-11.brep", "pump-carter.step", "screw.step", "sphere.step",
                    "storage-jar-offset-surfaces.step", "submarine-in-far-field.step",
                    "suspension-control-arm.step", "torus.brep"),
    test::file_test_name);

class ClosedFixtures : public testing::TestWithParam<const char*> {};

/// Eight octants that share no edge in the file but meet exactly, and a solid whose faces share
/// theirs.
TEST_P(ClosedFixtures, AreLeftAsOftenAsEntered) {
    expect_closed(repository("surfaces") / GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ClosedFixtures,
                         testing::Values("rational-sphere.step", "bored-block.step"),
                         test::file_test_name);

} // namespace
} // namespace keiko
