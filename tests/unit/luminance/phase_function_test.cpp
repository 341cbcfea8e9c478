#include "keiko/luminance/phase_function.h"

#include "keiko/base/units.h"
#include "keiko/math/quadrature.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

TEST(PhaseFunction, AgreesWithOracle) {
    const test::OracleTable table("phase");
    test::WorstError worst("p");
    for (const auto& row : table) {
        if (row.text("in.kind") != "k16") continue;
        const double cosine = std::cos(degrees_to_radians(row.number("in.gamma_deg")));
        worst.compare(row, fog_phase(cosine, row.number("in.par")), row.number("out.p"), 1e-11);
    }
}

TEST(PhaseFunction, ScattersAllLightThatItTakes) {
    for (const double k : {0.0, 1.0, 9.0, 50.0}) {
        const double whole = integrate([&](double c) { return fog_phase(c, k); }, -1, 1, 8);
        EXPECT_NEAR(2 * std::numbers::pi * whole, 1, 1e-14) << k;
    }
}
