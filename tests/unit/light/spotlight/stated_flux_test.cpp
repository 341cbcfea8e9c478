#include "keiko/light/rig/luminaire_remarks.h"
#include "keiko/light/spotlight/luminous_flux.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace keiko;

namespace {

/// 100 cd into every direction below the horizontal, 50 cd into all others.
PhotometricWeb two_halves() {
    const double edge = 90 + 1e-9;
    return {.type = PhotometricType::c,
            .candela = {{0, 90, edge, 180}, {0}, {100, 100, 50, 50}, PlaneSymmetry::axial},
            .lamp_flux = 1000};
}

constexpr double flux = 300 * std::numbers::pi; // 942.48 lm

} // namespace

TEST(StatedFlux, DownwardFluxIsThatOfTheLowerHalf) {
    EXPECT_NEAR(luminous_flux(two_halves()), flux, 1e-6);
    EXPECT_NEAR(downward_flux(two_halves()), flux * 2 / 3, 1e-6);
    PhotometricWeb up = two_halves();
    up.candela = {{90, 180}, {0}, {1, 1}, PlaneSymmetry::axial};
    EXPECT_EQ(downward_flux(up), 0);
}

TEST(StatedFlux, ThatAgreesIsNotRemarked) {
    PhotometricWeb web = two_halves();
    EXPECT_TRUE(flux_contradictions("x.ldt", web).empty());
    web.stated = {flux / 1000 * 1.009, 1000, 2 / 3.0 + 0.009};
    EXPECT_TRUE(flux_contradictions("x.ldt", web).empty());
}

TEST(StatedFlux, ThatContradictsTheTableIsRemarkedWithBothNumbers) {
    PhotometricWeb web = two_halves();
    web.stated = {flux / 1000 * 1.02, 1000, 2 / 3.0 - 0.02};
    const Diagnostics remarks = flux_contradictions("x.ldt", web);
    ASSERT_EQ(remarks.size(), 2U);
    for (const Diagnostic& remark : remarks) {
        EXPECT_EQ(remark.entity, "x.ldt");
        EXPECT_EQ(remark.severity, Severity::warning);
    }
    EXPECT_EQ(remarks[0].message,
              "the header states a light output ratio of 96.13 %, but its intensities add up to "
              "94.25 % of its 1000 lm");
    EXPECT_EQ(remarks[1].message,
              "the header states a downward flux fraction of 64.67 %, but its intensities add up "
              "to 66.67 %");
}

TEST(StatedFlux, OfLampsBelowTheLuminairesIsRemarked) {
    PhotometricWeb web = two_halves();
    web.lamp_flux = 900;
    const Diagnostics remarks = flux_contradictions("x.ies", web);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0].message,
              "the header states lamps of 900 lm, but its intensities add up to 942.5 lm");
    web.lamp_flux = 2000; // lost in the luminaire
    EXPECT_TRUE(flux_contradictions("x.ies", web).empty());
}
