#include "keiko/import/worker/load_model.h"

#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/piece_rays.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace keiko {
namespace {

/// Rays at the middle of every piece that is drawn of a body, and just beside its ends, in views
/// from random directions. `views`: in either projection.
test::RayTally census(const SurfaceModel& model, std::size_t views) {
    test::RayTally sum;
    test::Random random(test::first_seed());
    for (std::size_t i = 0; i < views; ++i) {
        const Vec3 direction = test::random_direction(random);
        for (const Projection projection : {Projection::perspective, Projection::orthographic})
            sum += test::rays_along(test::drawn(model, direction, projection), 0);
    }
    return sum;
}

std::string name_of_file(const testing::TestParamInfo<std::string>& file) {
    std::string name = file.param;
    for (const char sign : {'-', '.'}) std::replace(name.begin(), name.end(), sign, '_');
    return name;
}

class PieceCensus : public testing::TestWithParam<std::string> {
protected:
    void expect_no_wrong(const std::filesystem::path& file) {
        const test::RayTally tally = census(load_model(file), test::ray_count(2, 60));
        EXPECT_EQ(tally.wrong, 0u) << "of " << tally.places;
        EXPECT_LT(tally.undecided, tally.places / 2) << "of " << tally.places;
        EXPECT_LE(tally.forgiven, tally.places / 200) << "of " << tally.places;
        RecordProperty("places", std::to_string(tally.places));
        RecordProperty("undecided", std::to_string(tally.undecided));
        RecordProperty("forgiven", std::to_string(tally.forgiven));
    }
};

TEST_P(PieceCensus, MiddlesAndEndsAreAsRaysTell) {
    expect_no_wrong(test::repository("surfaces/" + GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Fixtures, PieceCensus,
                         testing::Values("hood.step", "bored-block.step", "dent.step", "pole.step",
                                         "rational-sphere.step", "trimmed-hole.step",
                                         "trimmed-island.step", "trimmed-two-holes.step",
                                         "seam-g0-gap.step", "seam-g1-angle.step", "shut-line.step",
                                         "concept-car.step"),
                         name_of_file);

class SharedPieceCensus : public PieceCensus {};

TEST_P(SharedPieceCensus, MiddlesAndEndsAreAsRaysTell) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    expect_no_wrong(test::shared_model(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Panels, SharedPieceCensus,
                         testing::Values("car-hood.brep", "car-front-fender.brep",
                                         "car-front-fender-converted.igs",
                                         "car-rear-deck-half-panel.brep"),
                         name_of_file);

} // namespace
} // namespace keiko
