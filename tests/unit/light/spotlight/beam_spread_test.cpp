#include "keiko/light/spotlight/beam_spread.h"

#include "keiko/base/units.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

using namespace keiko;

namespace {

using Intensity = std::function<double(double v, double h)>; ///< of angles in degrees

std::vector<double> angles_to(double last, double step = 1) {
    std::vector<double> angles;
    for (int i = 0; i * step <= last; ++i) angles.push_back(i * step);
    return angles;
}

/// Web of type C, tabulated up to `last`, in the planes 0, 90, 180 and 270.
PhotometricWeb web_of(const Intensity& intensity, double last) {
    const std::vector<double> vertical = angles_to(last), planes{0, 90, 180, 270};
    std::vector<double> values;
    for (const double h : planes)
        for (const double v : vertical) values.push_back(intensity(v, h));
    return {.type = PhotometricType::c, .candela = {vertical, planes, values, PlaneSymmetry::none}};
}

double cosine(double degrees) {
    return std::max(0.0, std::cos(degrees_to_radians(degrees)));
}

/// A spread found by the definition: the outermost of many directions within 90 degrees of the
/// axis, followed as long as the intensity stays.
std::pair<double, double> sampled_edges(const PhotometricWeb& web, double share, double plane,
                                        bool opposite) {
    constexpr int steps_per_degree = 100, half_turn = 180 * steps_per_degree,
                  quarter_turn = half_turn / 2;
    const auto at = [&](int step) {
        const double degrees = step / double{steps_per_degree};
        return intensity(web, off_axis(web.type, opposite ? 180 - degrees : degrees, plane));
    };
    double largest = 0;
    for (int i = -half_turn; i <= half_turn; ++i) largest = std::max(largest, at(i));
    int positive = quarter_turn, negative = -quarter_turn;
    while (at(positive) < share * largest) --positive;
    while (positive < half_turn && at(positive + 1) >= share * largest) ++positive;
    while (at(negative) < share * largest) ++negative;
    while (negative > -half_turn && at(negative - 1) >= share * largest) --negative;
    return {positive / double{steps_per_degree}, -negative / double{steps_per_degree}};
}

void expect_as_sampled(const PhotometricWeb& web, const std::string& name = "") {
    constexpr double within = 0.011; // of the samples
    for (const double plane : {0.0, 90.0})
        for (const double share : {0.5, 0.1}) {
            const auto spread = beam_spread(web, share, plane);
            if (!spread) continue;
            const auto [positive, negative] = sampled_edges(web, share, plane, spread->opposite);
            EXPECT_NEAR(spread->positive.angle, positive, within) << name << " " << plane;
            EXPECT_NEAR(spread->negative.angle, negative, within) << name << " " << plane;
        }
}

void expect_nested(const PhotometricWeb& web) {
    for (const double plane : {0.0, 90.0}) {
        const auto beam = beam_spread(web, 0.5, plane), field = beam_spread(web, 0.1, plane);
        ASSERT_EQ(beam.has_value(), field.has_value());
        if (!beam) continue;
        EXPECT_LE(beam->positive.angle, field->positive.angle);
        EXPECT_LE(beam->negative.angle, field->negative.angle);
        EXPECT_TRUE(beam->positive.reached || !field->positive.reached);
        EXPECT_TRUE(beam->negative.reached || !field->negative.reached);
    }
}

} // namespace

TEST(BeamSpread, OfCosinePowersIsItsClosedForm) {
    for (const double power : {1.0, 3.0, 20.0}) {
        const PhotometricWeb web =
            web_of([&](double v, double) { return std::pow(cosine(v), power); }, 90);
        for (const double share : {0.5, 0.1}) {
            const double half = radians_to_degrees(std::acos(std::pow(share, 1 / power)));
            const auto spread = beam_spread(web, share, 0);
            ASSERT_TRUE(spread && spread->full_angle());
            EXPECT_NEAR(*spread->full_angle(), 2 * half, 0.02);
            EXPECT_NEAR(spread->positive.angle, spread->negative.angle, 1e-9);
            EXPECT_FALSE(spread->opposite);
        }
        expect_as_sampled(web);
    }
}

TEST(BeamSpread, HasNoFullAngleWhereTheTableEndsAboveTheLimit) {
    // Grazing light at a wall: C0 never falls to a tenth, C180 does.
    const PhotometricWeb web = web_of(
        [](double v, double h) { return h == 0 ? 1 - v / 180 : std::max(0.0, 1 - v / 50); }, 90);
    const auto field = beam_spread(web, 0.1, 0);
    ASSERT_TRUE(field);
    EXPECT_EQ(field->positive, (SpreadEdge{90, false}));
    EXPECT_NEAR(field->negative.angle, 45, 1e-9);
    EXPECT_TRUE(field->negative.reached);
    EXPECT_FALSE(field->full_angle());
    expect_as_sampled(web);
}

TEST(BeamSpread, OfALampThatIsEvenAllRoundIsNotReached) {
    const PhotometricWeb web = web_of([](double, double) { return 7; }, 180);
    const auto beam = beam_spread(web, 0.5, 90);
    ASSERT_TRUE(beam);
    EXPECT_EQ(beam->positive, (SpreadEdge{180, false}));
    EXPECT_EQ(beam->negative, (SpreadEdge{180, false}));
    EXPECT_FALSE(beam->full_angle());
}

TEST(BeamSpread, OfOneSidedLightLiesOnItsSide) {
    // A triangle from 10 to 70 degrees in C0: half of it from 25 to 55; dark in C180.
    const PhotometricWeb web = web_of(
        [](double v, double h) { return h == 0 ? std::max(0.0, 30 - std::abs(v - 40)) : 0; }, 90);
    const auto beam = beam_spread(web, 0.5, 0);
    ASSERT_TRUE(beam && beam->full_angle());
    EXPECT_NEAR(beam->positive.angle, 55, 1e-9);
    EXPECT_NEAR(beam->negative.angle, -25, 1e-9);
    EXPECT_NEAR(*beam->full_angle(), 30, 1e-9);
    EXPECT_FALSE(beam_spread(web, 0.5, 90));
    expect_as_sampled(web);
}

TEST(BeamSpread, OfABatwingReachesOverBothWings) {
    // 20 % on the axis, peaks at 50 degrees: the dip is between the tenth and the half.
    const PhotometricWeb web = web_of(
        [](double v, double) { return std::max(0.0, v < 50 ? 20 + 1.6 * v : 100 - 4 * (v - 50)); },
        90);
    const auto beam = beam_spread(web, 0.5, 0), field = beam_spread(web, 0.1, 0);
    ASSERT_TRUE(beam && beam->full_angle() && field && field->full_angle());
    EXPECT_NEAR(*beam->full_angle(), 2 * 62.5, 1e-9);
    EXPECT_NEAR(*field->full_angle(), 2 * 72.5, 1e-9);
    expect_as_sampled(web);
}

TEST(BeamSpread, OfANarrowAsymmetricBeamHasTwoHalves) {
    const PhotometricWeb web = web_of(
        [](double v, double h) {
            const double x = h == 0 ? v : -v;
            return std::max(0.0, x > 2 ? 1 - (x - 2) / 8 : 1 - (2 - x) / 20);
        },
        90);
    const auto beam = beam_spread(web, 0.5, 0);
    ASSERT_TRUE(beam);
    EXPECT_NEAR(beam->positive.angle, 6, 1e-9);
    EXPECT_NEAR(beam->negative.angle, 8, 1e-9);
    expect_as_sampled(web);
}

TEST(BeamSpread, OfAnUplightIsAboutTheZenith) {
    const PhotometricWeb web = web_of([](double v, double) { return cosine(180 - v); }, 180);
    const auto beam = beam_spread(web, 0.5, 0);
    ASSERT_TRUE(beam && beam->full_angle());
    EXPECT_TRUE(beam->opposite);
    EXPECT_NEAR(*beam->full_angle(), 120, 0.02);
    expect_as_sampled(web);
}

TEST(BeamSpread, OfDirectAndIndirectLightIsThatOfTheBrighterHalf) {
    const PhotometricWeb web =
        web_of([](double v, double) { return v < 90 ? cosine(v) : 0.8 * cosine(180 - v); }, 180);
    const auto beam = beam_spread(web, 0.5, 0);
    ASSERT_TRUE(beam && beam->full_angle());
    EXPECT_FALSE(beam->opposite);
    EXPECT_NEAR(*beam->full_angle(), 120, 0.02);
    expect_as_sampled(web);
}

TEST(BeamSpread, OfHeadLampsAndFloodlightsFollowsTheirAngles) {
    // Falls to 0 at 20 degrees to the sides, at 10 upwards and at 40 downwards.
    const std::vector<double> vertical{-40, 0, 10}, level{-20, 0, 20}, mirrored{0, 20};
    const PhotometricWeb limited{
        .type = PhotometricType::a,
        .candela = {vertical, level, {0, 0, 0, 0, 8, 0, 0, 0, 0}, PlaneSymmetry::limited}};
    const PhotometricWeb lateral{
        .type = PhotometricType::b,
        .candela = {vertical, mirrored, {0, 8, 0, 0, 0, 0}, PlaneSymmetry::lateral}};
    for (const PhotometricWeb& web : {limited, lateral}) {
        const auto across = beam_spread(web, 0.5, 0), along = beam_spread(web, 0.5, 90);
        ASSERT_TRUE(across && along);
        EXPECT_NEAR(across->full_angle().value(), 20, 1e-9);
        EXPECT_NEAR(along->positive.angle, 5, 1e-9);
        EXPECT_NEAR(along->negative.angle, 20, 1e-9);
        expect_as_sampled(web);
    }
}

TEST(BeamSpread, OfRandomTablesIsTheSampledOneAndNested) {
    test::Random random(7);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> vertical = angles_to(trial % 2 == 0 ? 90 : 180, 15), values;
        for (std::size_t i = 0; i < 4 * vertical.size(); ++i)
            values.push_back(std::pow(test::uniform(random, 0, 1), 3));
        for (std::size_t plane = 1; plane < 4; ++plane) // one intensity on the axis
            values[plane * vertical.size()] = values[0],
                           values[(plane + 1) * vertical.size() - 1] = values[vertical.size() - 1];
        const PhotometricWeb web{
            .type = PhotometricType::c,
            .candela = {vertical, {0, 90, 180, 270}, values, PlaneSymmetry::none}};
        expect_nested(web);
        if (trial < 12) expect_as_sampled(web, "trial " + std::to_string(trial));
    }
}
