#include "keiko/spotlight/luminous_flux.h"

#include "keiko/base/units.h"

#include "spotlight_rows.h"
#include <gtest/gtest.h>

#include <memory>
#include <numbers>

using namespace keiko;
using std::numbers::pi;

namespace {

/// By the midpoint rule over the whole sphere.
double summed(const PhotometricWeb& web) {
    constexpr int rings = 720, sectors = 1440;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j)
            sum += intensity(web, web_direction(PhotometricType::c, (i + 0.5) * 180 / rings,
                                                (j + 0.5) * 360 / sectors)) *
                   std::sin((i + 0.5) * pi / rings);
    return sum * (pi / rings) * (2 * pi / sectors);
}

} // namespace

TEST(LuminousFlux, AgreesWithOracle) {
    const test::OracleTable table("spot_flux");
    test::WorstError worst("flux");
    for (const auto& row : table) {
        const Spotlight light = test::spotlight_in(row, DotReading::centred);
        // The table's quadrature runs across the edges of dots that do not fill their cells; the
        // next test holds those to their closed form.
        const auto* dots = std::get_if<Dots>(&light.pattern);
        const bool kinks = dots && dots->q_theta < 0;
        worst.compare(row, luminous_flux(light).r, row.number("out.flux"), kinks ? 2e-6 : 1e-11);
    }
}

TEST(LuminousFlux, OfDotsIsTheClosedFormOfTheirRings) {
    const Dots dots{.dphi = 60, .dtheta = 19.5, .q_phi = -0.231, .q_theta = -0.343};
    const Spotlight light{.half_angle = 58.5,
                          .profile = EdgeProfile{BeamEdge::sharp},
                          .intensity = Rgb(500),
                          .pattern = dots};
    const double period = degrees_to_radians(dots.dtheta), width = period / 2 / (1 - dots.q_theta);
    double rings = 0;
    for (int i = 0; i < 3; ++i)
        rings += std::sin((i + 0.5) * period) * 2 * (1 - std::cos(width)) / width;
    EXPECT_NEAR(luminous_flux(light).r, 500 * pi * mean_of_k(dots.q_phi) * rings, 1e-9);
}

TEST(LuminousFlux, OfWarnsPowerIsItsClosedForm) {
    const Spotlight light{.half_angle = 180, .profile = CosinePower{4}, .intensity = Rgb(100)};
    EXPECT_NEAR(luminous_flux(light).g, 2 * pi * 100 / 5, 1e-9);
}

TEST(LuminousFlux, DoesNotDependOnSpin) {
    Spotlight light{.pattern = Petals{7, -0.3}};
    const Rgb still = luminous_flux(light);
    light.spin = 13;
    EXPECT_EQ(luminous_flux(light), still);
}

TEST(LuminousFlux, OfEvenWebsIsThatOfTheirSolidAngle) {
    const IntensityTable sphere({0, 90, 180}, {0}, {3, 3, 3}, PlaneSymmetry::axial);
    EXPECT_NEAR(luminous_flux({.type = PhotometricType::c, .candela = sphere}), 12 * pi, 1e-10);
    const std::vector<double> half{-90, 90}, even(4, 3.0);
    for (const auto type : {PhotometricType::a, PhotometricType::b})
        EXPECT_NEAR(
            luminous_flux({.type = type, .candela = {half, half, even, PlaneSymmetry::limited}}),
            6 * pi, 1e-10);
    const IntensityTable folded(half, {0, 90}, even, PlaneSymmetry::lateral);
    EXPECT_NEAR(luminous_flux({.type = PhotometricType::b, .candela = folded}), 6 * pi, 1e-10);
}

TEST(LuminousFlux, OfAWebIsTheSumOverItsDirections) {
    const std::vector<double> values{5, 3, 1, 8, 6, 4, 2, 9, 7};
    using enum PlaneSymmetry;
    for (const PlaneSymmetry symmetry : {none, bilateral}) {
        const PhotometricWeb web{.type = PhotometricType::c,
                                 .candela = {{0, 50, 120}, {0, 70, 180}, values, symmetry}};
        EXPECT_NEAR(luminous_flux(web), summed(web), 5e-4 * summed(web));
    }
    for (const auto type : {PhotometricType::a, PhotometricType::b}) {
        const PhotometricWeb web{.type = type,
                                 .candela = {{-60, 0, 80}, {0, 20, 70}, values, lateral}};
        EXPECT_NEAR(luminous_flux(web), summed(web), 5e-4 * summed(web));
    }
}
