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
        const double cosine = std::cos(degrees_to_radians(row.number("in.gamma_deg")));
        const double parameter = row.number("in.par");
        const PhaseFunction function = row.text("in.kind") == "k16"
                                           ? PhaseFunction(HazePhase{parameter})
                                           : PhaseFunction(HenyeyGreenstein{parameter});
        worst.compare(row, phase(function, cosine), row.number("out.p"), 1e-11);
    }
}

TEST(PhaseFunction, ScattersAllLightThatItTakes) {
    const auto whole = [](const PhaseFunction& function, int order) {
        return 2 * std::numbers::pi *
               integrate([&](double c) { return phase(function, c); }, -1, 1, order);
    };
    for (const double k : {0.0, 1.0, 9.0, 50.0}) EXPECT_NEAR(whole(HazePhase{k}, 8), 1, 1e-14) << k;
    for (const double g : {-0.5, 0.0, 0.3, 0.6})
        EXPECT_NEAR(whole(HenyeyGreenstein{g}, 60), 1, 1e-12) << g;
}
