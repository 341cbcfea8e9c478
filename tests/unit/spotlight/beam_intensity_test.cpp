#include "keiko/spotlight/beam_intensity.h"

#include "keiko/base/units.h"
#include "keiko/luminance/photometry.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <numbers>

using namespace keiko;

namespace {

BeamEdge edge_named(const std::string& name) {
    if (name == "sharp") return BeamEdge::sharp;
    return name == "soft" ? BeamEdge::soft : BeamEdge::mixed;
}

Spotlight light_in(const test::OracleRow& row) {
    return {.half_angle = row.number("in.gamma_deg"),
            .edge = edge_named(row.text("in.base")),
            .q = row.number("in.qmix"),
            .intensity = Rgb(row.number("in.I0"))};
}

} // namespace

TEST(BeamIntensity, AgreesWithOracle) {
    const test::OracleTable table("spot_distribution");
    test::WorstError worst("I");
    for (const auto& row : table) {
        if (row.text("in.pattern") != "none") continue;
        const double theta = degrees_to_radians(row.number("in.theta_deg"));
        const Vec3 point(std::sin(theta), 0, -std::cos(theta));
        worst.compare(row, intensity_towards(light_in(row), point * 3000).g,
                      row.number("out.I_literal"), 1e-11);
    }
}

TEST(BeamIntensity, FluxAgreesWithOracle) {
    const test::OracleTable table("spot_flux");
    test::WorstError worst("flux");
    for (const auto& row : table)
        if (row.text("in.pattern") == "none")
            worst.compare(row, luminous_flux(light_in(row)).r, row.number("out.flux"), 1e-11);
}

TEST(BeamIntensity, IlluminanceAgreesWithOracle) {
    const test::OracleTable table("spot_geometry");
    test::WorstError intensity("I"), lux("E"), shown("Lum");
    for (const auto& row : table) {
        const Spotlight light{.position = row.vector("in.Q") * 1000,
                              .aim = row.vector("in.C") * 1000,
                              .half_angle = row.number("in.gamma_deg"),
                              .intensity = Rgb(row.number("in.I0"))};
        const Vec3 point = row.vector("in.Pt") * 1000;
        const Rgb e = illuminance(light, point, row.unit("in.N"));
        intensity.compare(row, intensity_towards(light, point).b, row.number("out.I"), 1e-11);
        lux.compare(row, e.g, row.number("out.E"), 1e-11);
        shown.compare(row, lambert_luminance(Rgb(row.number("in.rho")), e).g, row.number("out.Lum"),
                      1e-11);
    }
}

TEST(BeamIntensity, RimBelongsToTheBeam) {
    const Spotlight sharp{.half_angle = 30, .edge = BeamEdge::sharp};
    const Spotlight mixed{.half_angle = 30, .edge = BeamEdge::mixed, .q = 0.25};
    const double rim = rim_versine(sharp);
    EXPECT_EQ(relative_intensity(sharp, rim), 1);
    EXPECT_EQ(relative_intensity(sharp, std::nextafter(rim, 1)), 0);
    EXPECT_EQ(relative_intensity(mixed, rim), 0.25);
    EXPECT_EQ(relative_intensity(mixed, 0), 1);
}

TEST(BeamIntensity, WideBeamsAreLambertAndCardioid) {
    const Spotlight lambert{.half_angle = 90}, cardioid{.half_angle = 180};
    EXPECT_NEAR(relative_intensity(lambert, 1 - 0.3), 0.3, 1e-15);
    EXPECT_NEAR(relative_intensity(cardioid, 1 + 0.3), (1 - 0.3) / 2, 1e-15);
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
    EXPECT_EQ(intensity_towards({.position = Vec3(1), .aim = Vec3(1)}, Vec3(0)), Rgb());
    EXPECT_EQ(illuminance({}, Vec3(0), Vec3(0, 0, 1)), Rgb());
    EXPECT_EQ(illuminance({}, Vec3(0, 0, -1000), Vec3(0, 0, -1)), Rgb());
}
