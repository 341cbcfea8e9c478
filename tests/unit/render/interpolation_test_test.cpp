#include "keiko/render/lighting/interpolation_test.h"

#include "tests/unit/render/plate_points.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace keiko;
using test::PlateSpots;

namespace {

const Lights the_light{0};

/// A trial of all places with the one light open.
struct Trial {
    const PlateSpots& plate;
    double error;
    LightSamples lights{plate.integrator(), plate.grid()};
    std::vector<Rgb> seen = std::vector<Rgb>(plate.grid().size());
    double left = 1;
    InterpolationTest::Accepted told =
        InterpolationTest(plate.integrator(), plate.grid(), seen, error, lights)
            .tell(PlateSpots::all(), {}, {the_light, the_light}, left);

    bool tells_none() const {
        return told.lines.empty() && told.parabolas.empty() && told.seen.empty();
    }
    bool tells_none_for_sure() const { return tells_none() || told.threatened == the_light; }
    /// Share of the light, over all places, by which a fit through places that were asked is off.
    double most_off(const Interpolant& fit) const {
        const LightPolynomial light =
            fit.through([&](const Pixel& p) { return lights.light(p.x, p.y, 0); });
        double most = 0;
        for (int y = 0; y < PlateSpots::side; ++y)
            for (int x = 0; x < PlateSpots::side; ++x) {
                const DirectLight exact = plate.integrator().direct_light(*plate.grid().at(x, y));
                const DirectLight got = light.at(plate.grid().place({x, y}));
                most = std::max(most, std::abs(got.illuminance.g / exact.illuminance.g - 1));
            }
        return most;
    }
};

/// Under a sun in the zenith, `width` places wide from between two columns on, all along y.
PlateSpots under_bar(double first_column, double width) {
    return PlateSpots(Sun(), PlateSpots::Screen{{first_column, -100, 50}, width, 200});
}

/// Plate under the lamp; a screen hides an end of the lamp from where y is more than `kink` on.
PlateSpots under_edge(double kink) {
    constexpr double height = 500, lamp = 1000, end = 500, share = height / lamp;
    const double edge = kink + (end - kink) * share;
    return PlateSpots(test::one_lamp(), PlateSpots::Screen{{-300, edge, height}, 600, 300});
}

} // namespace

TEST(InterpolationTest, TellsEvenLightByLinesAtNoError) {
    const PlateSpots plate{Sun()};
    const Trial trial{plate, 1e-6};
    EXPECT_EQ(trial.told.lines, the_light);
    EXPECT_TRUE(trial.told.parabolas.empty());
    EXPECT_LT(trial.most_off(Interpolant::lines(plate.grid(), PlateSpots::all())), 1e-14);
    EXPECT_NEAR(trial.left, 1, 1e-6);
}

// Over 16 mm below a lamp at 1 m light is off a line by some 1e-4.
TEST(InterpolationTest, TellsBentLightByParabolasWithinTheError) {
    const PlateSpots plate{test::one_lamp()};
    constexpr double error = 5e-5;
    const Trial trial{plate, error};
    EXPECT_EQ(trial.told.parabolas, the_light);
    EXPECT_TRUE(trial.told.lines.empty());
    EXPECT_GT(trial.most_off(Interpolant::lines(plate.grid(), PlateSpots::all())), error);
    EXPECT_LT(trial.most_off(Interpolant::parabolas(plate.grid(), PlateSpots::all())), error / 100);
    EXPECT_GT(trial.left, 0);
    EXPECT_LT(trial.left, 1);
}

// What is seen of a lamp that nothing hides is linear without error.
TEST(InterpolationTest, TellsNoBentLightWhereNoErrorIsAllowed) {
    const PlateSpots plate{test::one_lamp()};
    const Trial trial{plate, 0};
    EXPECT_TRUE(trial.told.lines.empty());
    EXPECT_TRUE(trial.told.parabolas.empty());
    EXPECT_EQ(trial.told.seen, the_light);
}

// The light has a kink there, and so has the end of what is seen of the lamp.
TEST(InterpolationTest, TellsNoKinkedLight) {
    for (double kink = 0.5; kink < 15; ++kink)
        EXPECT_TRUE((Trial{under_edge(kink), 5e-5}.tells_none())) << kink;
}

// A parabola may do where the lamp is seen in part all over; at the error that it does not keep to,
// what is seen of the lamp is linear, here exactly.
TEST(InterpolationTest, TellsLampsSeenInPartByTheirEnds) {
    const PlateSpots plate = under_edge(-10);
    EXPECT_EQ((Trial{plate, 5e-5}.told.parabolas), the_light);
    const Trial exacting{plate, 1e-8};
    EXPECT_TRUE(exacting.told.parabolas.empty());
    EXPECT_EQ(exacting.told.seen, the_light);
}

TEST(InterpolationTest, TellsNoLightAcrossTheEdgeOfItsShadow) {
    for (double edge = 0.5; edge < 16; ++edge)
        EXPECT_TRUE((Trial{under_bar(edge, 100), 1e-3}.tells_none())) << edge;
}

// Half a square wide: some column of the corners and middles lies in it.
TEST(InterpolationTest, MeetsShadowsOfHalfASquareWhereverTheyLie) {
    for (double first = -7.5; first < 16; ++first)
        EXPECT_TRUE((Trial{under_bar(first, 8), 1e-3}.tells_none())) << first;
}

// The plate is flat: what no place meets may still come between.
TEST(InterpolationTest, StepsOverNoNarrowerShadows) {
    for (const double width : {2.0, 0.2, 1e-3})
        for (double first = 0.5; first < 15; ++first)
            EXPECT_TRUE((Trial{under_bar(first, width), 1e-3}.tells_none_for_sure())) << first;
    EXPECT_TRUE((Trial{under_bar(16.5, 2), 1e-3}.told.threatened.empty()));
}
