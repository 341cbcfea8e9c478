#include "keiko/light/spotlight/point_source.h"

#include "keiko/light/spotlight/point_light.h"
#include "keiko/math/quadrature.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

PointSource source(PointDistribution distribution, double exponent = 1) {
    return {.position = {100, 200, 1000},
            .axis = {0, 0, -2},
            .distribution = distribution,
            .exponent = exponent,
            .intensity = Rgb(10, 20, 30)};
}

const std::array all{source(PointDistribution::uniform), source(PointDistribution::cardioid),
                     source(PointDistribution::power, 1), source(PointDistribution::power, 7.5)};

Vec3 under(const PointSource& light, double theta) {
    return light.position + Vec3(std::sin(theta), 0, -std::cos(theta)) * 700;
}

TEST(PointSource, FluxIsTheIntegralOfTheIntensity) {
    for (const PointSource& light : all) {
        const auto ring = [&](double theta) {
            return intensity_towards(light, under(light, theta)).g * 2 * pi * std::sin(theta);
        };
        const double flux = integrate(ring, 0, pi / 2, 40) + integrate(ring, pi / 2, pi, 40);
        EXPECT_NEAR(flux, 20 * flux_of_unit_intensity(light), 1e-6 * flux);
    }
}

TEST(PointSource, DistributionsAreThoseOfTheBook) {
    const double theta = 1.1, cosine = std::cos(theta);
    const auto share = [&](const PointSource& light) {
        return intensity_towards(light, under(light, theta)).r / 10;
    };
    EXPECT_NEAR(share(all[0]), 1, 1e-14);
    EXPECT_NEAR(share(all[1]), (1 + cosine) / 2, 1e-14);
    EXPECT_NEAR(share(all[2]), cosine, 1e-14);
    EXPECT_NEAR(share(all[3]), std::pow(cosine, 7.5), 1e-14);
    EXPECT_EQ(intensity_towards(all[2], under(all[2], 1.7)), Rgb(0));
    EXPECT_EQ(intensity_towards(all[0], all[0].position), Rgb(0));
}

TEST(PointSource, IlluminanceFallsWithTheSquareOfTheDistance) {
    const Rgb lx = illuminance(all[1], Vec3(100, 200, 0), Vec3(0, 0.6, 0.8));
    EXPECT_NEAR(lx.b, 30 * 0.8, 1e-12); // 1 m below
    EXPECT_EQ(illuminance(all[1], Vec3(100, 200, 0), Vec3(0, 0, -1)), Rgb(0));
}

/// A power of the cosine lights what is before the lamp; the others light everything.
TEST(PointSource, BeamIsWhereItShines) {
    const Segment across{{0, 0, 500}, {0, 0, 2500}}, behind{{0, 0, 1500}, {9, 0, 2500}};
    EXPECT_EQ(in_beam(all[0], behind), IntervalSet::whole());
    EXPECT_EQ(in_beam(all[1], behind), IntervalSet::whole());
    EXPECT_TRUE(in_beam(all[2], behind).empty());
    EXPECT_EQ(in_beam(all[2], across), IntervalSet::whole(0, 0.25));
    EXPECT_EQ(in_beam(all[2], {across.b, across.a}), IntervalSet::whole(0.75, 1));
}

} // namespace
} // namespace keiko
