#include "keiko/base/units.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/spotlight/spotlight.h"

#include "spotlight_rows.h"
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

using namespace keiko;

TEST(BeamIntensity, AgreesWithOracle) {
    const test::OracleTable table("spot_distribution");
    test::WorstError literal("I_literal"), centred("I_centred");
    for (const auto& row : table) {
        const double theta = degrees_to_radians(row.number("in.theta_deg"));
        const double phi = degrees_to_radians(row.number("in.phi_deg"));
        for (const DotReading reading : {DotReading::literal, DotReading::centred}) {
            const Spotlight light = test::spotlight_in(row, reading);
            const Vec3 way =
                beam_frame(light.aim - light.position, light.reference).world(theta, phi);
            const bool printed = reading == DotReading::literal;
            (printed ? literal : centred)
                .compare(row, intensity_towards(light, light.position + way * 3000).g,
                         row.number(printed ? "out.I_literal" : "out.I_centred"), 1e-11);
        }
    }
}

TEST(BeamIntensity, AgreesWithOracleOfTables) {
    const test::OracleTable table("spot_tabular");
    test::WorstError linear("I_theta"), cosine("I_cos");
    std::vector<double> angles;
    for (int i = 0; i <= 36; ++i) angles.push_back(5 * i);
    for (const auto& row : table) {
        const double theta = degrees_to_radians(row.number("in.theta_deg"));
        for (const auto how : {TableInterpolation::linear, TableInterpolation::cosine}) {
            const Spotlight light{
                .half_angle = 180,
                .profile = std::make_shared<const IntensityTable>(
                    angles, std::vector<double>{0}, row.list("in.tab"), PlaneSymmetry::axial, how),
                .intensity = Rgb(1)};
            const Vec3 point(std::sin(theta), 0, -std::cos(theta));
            if (how == TableInterpolation::linear)
                linear.compare(row, intensity_towards(light, point).r, row.number("out.I_theta"),
                               1e-11);
            else
                cosine.compare(row, intensity_towards(light, point).r, row.number("out.I_cos"),
                               1e-11);
        }
    }
}

TEST(BeamIntensity, IlluminanceAgreesWithOracle) {
    const test::OracleTable table("spot_geometry");
    test::WorstError theta("theta"), phi("phi"), dihedral("cosphi_dihedral");
    test::WorstError distance("r"), intensity("I"), lux("E"), shown("Lum");
    for (const auto& row : table) {
        const Spotlight light{.position = row.vector("in.Q") * 1000,
                              .aim = row.vector("in.C") * 1000,
                              .half_angle = row.number("in.gamma_deg"),
                              .intensity = Rgb(row.number("in.I0")),
                              .reference = (row.vector("in.R") - row.vector("in.Q")) * 1000};
        const Vec3 point = row.vector("in.Pt") * 1000;
        const BeamDirection direction =
            BeamIntensity(light).frame().direction((point - light.position).normalized());
        theta.compare(row, radians_to_degrees(direction.theta()), row.number("out.theta_deg"),
                      1e-11);
        phi.compare(row, radians_to_degrees(direction.phi()), row.number("out.phi_deg"), 1e-11);
        dihedral.compare(row, std::cos(direction.phi()), row.number("out.cosphi_dihedral"), 1e-13);
        const Rgb e = illuminance(light, point, row.unit("in.N"));
        distance.compare(row, metres((point - light.position).length()), row.number("out.r"),
                         1e-11);
        intensity.compare(row, intensity_towards(light, point).b, row.number("out.I"), 1e-11);
        lux.compare(row, e.g, row.number("out.E"), 1e-11);
        shown.compare(row, lambert_luminance(Rgb(row.number("in.rho")), e).g, row.number("out.Lum"),
                      1e-11);
    }
}

TEST(BeamIntensity, SpinTurnsThePatternBack) {
    Spotlight light{.half_angle = 40, .pattern = Petals{5, 0}, .hue = true};
    const BeamFrame frame = BeamIntensity(light).frame();
    const double theta = 0.3;
    const Rgb still = intensity_towards(light, frame.world(theta, degrees_to_radians(70)));
    light.spin = 25;
    const Rgb turned = intensity_towards(light, frame.world(theta, degrees_to_radians(45)));
    EXPECT_GT(still.g, 100);
    for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b})
        EXPECT_NEAR(turned.*channel, still.*channel, 1e-9);
}

TEST(BeamIntensity, AnEllipticBeamEndsAtItsTwoHalfAngles) {
    const Spotlight light{.half_angle = 50,
                          .profile = EdgeProfile{BeamEdge::mixed, 0.25},
                          .intensity = Rgb(1),
                          .half_angle_across = 10};
    const BeamIntensity intensity(light);
    const auto at = [&](double theta, double phi) {
        return intensity(
                   intensity.frame().world(degrees_to_radians(theta), degrees_to_radians(phi)))
            .g;
    };
    for (const auto& [rim, phi] :
         {std::pair(50.0, 0.0), {50.0, 180.0}, {10.0, 90.0}, {10.0, 270.0}}) {
        EXPECT_NEAR(at(rim - 1e-7, phi), 0.25, 1e-6);
        EXPECT_EQ(at(rim + 1e-7, phi), 0);
        EXPECT_NEAR(at(0, phi), 1, 1e-12);
    }
}

TEST(BeamIntensity, NarrowBeamsKeepTheirDigits) {
    // Half a milliradian off the axis of a beam of one: 1 - (1/2)^2 up to 1e-7.
    const Spotlight narrow{.half_angle = radians_to_degrees(1e-3), .intensity = Rgb(1)};
    const double theta = 5e-4;
    const double exact = 1 - std::pow(std::sin(theta / 2) / std::sin(5e-4), 2);
    EXPECT_NEAR(intensity_towards(narrow, Vec3(std::sin(theta), 0, -std::cos(theta))).g, exact,
                1e-12);
}

TEST(BeamIntensity, ALampWithoutDirectionOrDistanceLightsNothing) {
    EXPECT_EQ(intensity_towards(Spotlight{.position = Vec3(1), .aim = Vec3(1)}, Vec3(0)), Rgb());
    EXPECT_EQ(illuminance(Spotlight(), Vec3(0), Vec3(0, 0, 1)), Rgb());
    EXPECT_EQ(illuminance(Spotlight(), Vec3(0, 0, -1000), Vec3(0, 0, -1)), Rgb());
}
