#include "keiko/light/spotlight/luminous_flux.h"

#include "keiko/base/units.h"
#include "keiko/light/spotlight/spotlight.h"

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

/// lm of an elliptic beam by the midpoint rule over the ellipse in the plane 1 from the lamp.
double summed(const Spotlight& light, int rings) {
    const int sectors = 3 * rings;
    const BeamIntensity intensity(light);
    const double a = std::tan(degrees_to_radians(light.half_angle)),
                 b = std::tan(degrees_to_radians(*light.half_angle_across));
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double rho = (i + 0.5) / rings, turn = (j + 0.5) * 2 * pi / sectors;
            const Vec3 way(rho * a * std::cos(turn), rho * b * std::sin(turn), 1);
            const double cosine = 1 / way.length();
            const BeamDirection direction{1 - cosine, way.x * cosine, way.y * cosine};
            sum += intensity.towards(direction).r * rho * cosine * cosine * cosine;
        }
    return sum * a * b / rings * 2 * pi / sectors;
}

/// Five angles, three of them within the rims of the beams below, and three planes.
TableProfile coarse_table(TableInterpolation interpolation) {
    return std::make_shared<const IntensityTable>(
        std::vector<double>{0, 10, 25, 45, 90}, std::vector<double>{0, 100, 230},
        std::vector<double>{9, 8, 2, 5, 1, 9, 3, 6, 1, 2, 9, 5, 7, 0, 4}, PlaneSymmetry::none,
        interpolation);
}

} // namespace

TEST(LuminousFlux, OfEllipticBeamsOfTablesIsTheSumOverTheirDirections) {
    using enum TableInterpolation;
    for (const auto interpolation : {linear, cosine})
        for (const double across : {12.0, 33.0, 70.0})
            for (const double spin : {0.0, 50.0}) {
                const Spotlight light{.half_angle = 40,
                                      .profile = coarse_table(interpolation),
                                      .spin = spin,
                                      .half_angle_across = across};
                // The error falls with the square of the number of rings.
                const double expected = (4 * summed(light, 400) - summed(light, 200)) / 3;
                EXPECT_NEAR(luminous_flux(light).r, expected, 2e-6 * expected)
                    << across << " " << spin;
            }
}

/// Solid angle of an elliptic cone, whose boundary is integrated along the ellipse by Green's
/// theorem.
TEST(LuminousFlux, OfSlimEllipticBeamsIsTheirSolidAngle) {
    for (const double across : {0.5, 3.0, 40.0, 88.0}) {
        const Spotlight light{.half_angle = 80,
                              .profile = EdgeProfile{BeamEdge::sharp},
                              .intensity = Rgb(1),
                              .half_angle_across = across};
        const double a = std::tan(degrees_to_radians(80)), b = std::tan(degrees_to_radians(across));
        const auto part = [&](double t) {
            const double x = a * std::cos(t), y = b * std::sin(t), square = x * x + y * y;
            return (1 - 1 / std::sqrt(1 + square)) * a * b / square;
        };
        constexpr int steps = 400'000; // the trapezoid rule of a periodic function
        double expected = 0;
        for (int i = 0; i < steps; ++i) expected += part(2 * pi * i / steps) * 2 * pi / steps;
        EXPECT_NEAR(luminous_flux(light).r, expected, 1e-12 * expected) << across;
    }
}

TEST(LuminousFlux, AgreesWithOracle) {
    const test::OracleTable table("spot_flux");
    test::WorstError worst("flux");
    for (const auto& row : table) {
        const Spotlight light = test::spotlight_in(row, DotReading::centred);
        // The table's quadrature runs across the edges of dots that do not fill their cells, and
        // is 1.27e-6 too small in row 8: the next test holds those to their closed form.
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
