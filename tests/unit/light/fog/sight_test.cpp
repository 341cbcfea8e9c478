#include "keiko/light/fog/sight.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Sight, ContrastOfAnObjectAgreesWithOracle) {
    test::WorstError luminance("L"), near("C0"), far("C"), range("range"), mor("mor"),
        black("koschmieder");
    for (const auto& row : test::OracleTable("koschmieder")) {
        const double horizon = row.number("in.Lh"), extinction = row.number("in.sigma");
        const double passed = std::exp(-extinction * row.number("in.d"));
        const double contrast = luminance_contrast(row.number("in.Lo"), horizon);
        near.compare(row, contrast, row.number("out.C0"), 1e-12);
        far.compare(row, contrast * passed, row.number("out.C"), 1e-12);
        luminance.compare(row, horizon * (1 + contrast * passed), row.number("out.L"), 1e-12);
        range.compare(row, visual_range(contrast, extinction, row.number("in.eps")),
                      row.number("out.range"), 1e-12);
        mor.compare(row, meteorological_range(extinction), row.number("out.mor"), 1e-12);
        black.compare(row, visual_range(-1, extinction, 0.02), row.number("out.koschmieder"),
                      1e-12);
    }
}

TEST(Sight, SignalLampsAgreeWithOracle) {
    test::WorstError lux("E"), range("range"), required("I_needed"), clear("range_clear");
    for (const auto& row : test::OracleTable("allard")) {
        const double intensity = row.number("in.I"), extinction = row.number("in.sigma");
        const double distance = row.number("in.d"), least = row.number("in.E_t");
        lux.compare(row, signal_illuminance(intensity, extinction, distance), row.number("out.E"),
                    1e-11, 0);
        range.compare(row, signal_range(intensity, extinction, least), row.number("out.range"),
                      1e-11);
        required.compare(row, required_intensity(least, extinction, distance),
                         row.number("out.I_needed"), 1e-11);
        clear.compare(row, signal_range(intensity, 0, least), row.number("out.range_clear"), 1e-11);
    }
}

TEST(Sight, SignsAgreeWithOracle) {
    test::WorstError contrast("C"), range("range"), surround("C_s"), legend("Ll_d"), panel("Lp_d");
    for (const auto& row : test::OracleTable("sign_contrast")) {
        const SignLuminances sign{row.number("in.Ll"), row.number("in.Lp"), row.number("in.Ja")};
        const double extinction = row.number("in.sigma");
        const double passed = std::exp(-extinction * row.number("in.d"));
        const double added = sign.airlight * (1 - passed);
        legend.compare(row, sign.legend * passed + added, row.number("out.Ll_d"), 1e-12);
        panel.compare(row, sign.panel * passed + added, row.number("out.Lp_d"), 1e-12);
        contrast.compare(row, sign_contrast(sign, passed, added), row.number("out.C"), 1e-12);
        const double legible = legible_range(sign, extinction, row.number("in.eps"));
        if (row.has("out.range"))
            range.compare(row, legible, row.number("out.range"), 1e-12);
        else
            EXPECT_EQ(legible, infinity) << row.id();
        if (row.has("out.C_s"))
            surround.compare(row, luminance_contrast(sign.panel, sign.airlight) * passed,
                             row.number("out.C_s"), 1e-12);
    }
}

/// At its range a lamp gives just what the eye needs, from the thinnest haze to the thickest fog.
TEST(Sight, RangeOfALampIsWhereItsLightIsJustEnough) {
    for (const double extinction : {0.0, 1e-12, 1e-6, 1e-3, 0.1, 5.0, 100.0})
        for (const double intensity : {1e-6, 1.0, 1e6}) {
            const double range = signal_range(intensity, extinction, 2e-7);
            EXPECT_NEAR(signal_illuminance(intensity, extinction, range), 2e-7, 1e-17)
                << extinction << " " << intensity;
        }
}

TEST(Sight, WhatCannotBeSeenFromNearHasNoRange) {
    EXPECT_EQ(visual_range(0.04, 0.01, 0.05), 0);
    EXPECT_EQ(visual_range(0, 0.01, 0.05), 0);
    EXPECT_EQ(visual_range(-0.5, 0, 0.05), infinity);
    EXPECT_EQ(legible_range({40, 40, 10}, 0.01, 0.05), 0);
    EXPECT_EQ(legible_range({41, 40, 0}, 0.01, 0.05), 0);
    EXPECT_EQ(legible_range({400, 0, 0}, 0.01, 0.05), infinity);
    EXPECT_EQ(sign_contrast({400, 0, 0}, 0.5, 0), infinity);
    EXPECT_EQ(sign_contrast({0, 0, 0}, 0.5, 0), 0);
    EXPECT_EQ(signal_range(0, 0.01, 2e-7), 0);
}

} // namespace
} // namespace keiko
