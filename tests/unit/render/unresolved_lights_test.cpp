#include "keiko/render/lighting/light_samples.h"

#include "tests/unit/render/plate_points.h"
#include <gtest/gtest.h>

using namespace keiko;
using test::PlateSpots;

namespace {

constexpr Rectangle all = PlateSpots::all();
const LinearlySeen linear{0, all};

/// Linear in either coordinate of the grid: an end of what is seen, and the share of the width.
double end_at(const Pixel& p) {
    return 0.3 + 0.02 * p.x + 0.01 * p.y + 0.001 * p.x * p.y;
}

void take_at_corners(LightSamples& lights) {
    for (const Pixel& p : all.corners())
        lights.take(p.x, p.y, 0, {IntervalSet::whole(0, end_at(p)), end_at(p)});
}

} // namespace

TEST(UnresolvedLights, SeenLinearlyBetweenCorners) {
    const PlateSpots plate{test::one_lamp()};
    LightSamples lights(plate.integrator(), plate.grid());
    take_at_corners(lights);
    for (int y = 0; y < PlateSpots::side; ++y)
        for (int x = 0; x < PlateSpots::side; ++x) {
            const auto seen = seen_between_corners(lights, plate.grid(), linear, {x, y});
            ASSERT_TRUE(seen && seen->axis.size() == 1);
            EXPECT_EQ(seen->axis[0].begin, 0);
            EXPECT_NEAR(seen->axis[0].end, end_at({x, y}), 1e-14);
            EXPECT_NEAR(seen->share, end_at({x, y}), 1e-14);
        }
}

TEST(UnresolvedLights, AreNotSeenLinearlyBetweenCornersThatSeeOtherNumbersOfParts) {
    const PlateSpots plate{test::one_lamp()};
    for (const IntervalSet& odd : {IntervalSet(), IntervalSet({{0, 0.2}, {0.4, 1}})}) {
        LightSamples lights(plate.integrator(), plate.grid());
        take_at_corners(lights);
        lights.take(all.x1, all.y1, 0, {odd});
        EXPECT_FALSE(seen_between_corners(lights, plate.grid(), linear, {5, 7}));
    }
}

// A lamp whose visible part is given linearly is not queried, though all of it is visible.
TEST(UnresolvedLights, BringWhatIsSeenLinearlyOfThem) {
    const PlateSpots plate{test::one_lamp()};
    LightSamples lights(plate.integrator(), plate.grid());
    take_at_corners(lights);
    const Pixel p{5, 7};
    find({.lit = {0}, .seen = {}, .linearly_seen = {linear}}, plate.grid(), p, lights);
    EXPECT_NEAR(lights.seen(p.x, p.y, 0).axis[0].end, end_at(p), 1e-14);
    const DirectLight expected = lights.if_seen(p.x, p.y, 0, lights.seen(p.x, p.y, 0));
    EXPECT_GT(expected.illuminance.g, 0);
    EXPECT_EQ(lights.light(p.x, p.y, 0).illuminance, expected.illuminance);

    find({.lit = {0}, .seen = {0}}, plate.grid(), p, lights);
    EXPECT_EQ(lights.seen(p.x, p.y, 0).axis, IntervalSet::whole());
    EXPECT_GT(lights.light(p.x, p.y, 0).illuminance.g, expected.illuminance.g);
}
