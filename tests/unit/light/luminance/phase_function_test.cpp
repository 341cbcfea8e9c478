#include "keiko/base/units.h"
#include "keiko/light/fog/medium.h"
#include "keiko/math/quadrature.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <variant>

using namespace keiko;

namespace {

PhaseFunction phase_in(const test::OracleRow& row) {
    if (row.text("in.kind") == "hg") return HenyeyGreenstein{row.number("in.par")};
    return HazePhase{row.number("in.par")};
}

} // namespace

TEST(PhaseFunction, AgreesWithOracle) {
    const test::OracleTable table("phase");
    test::WorstError worst("p");
    for (const auto& row : table) {
        const double cosine = std::cos(degrees_to_radians(row.number("in.gamma_deg")));
        worst.compare(row, phase(phase_in(row), cosine), row.number("out.p"), 1e-11);
    }
}

TEST(PhaseFunction, MeansAgreeWithOracle) {
    const test::OracleTable table("phase");
    test::WorstError norm("norm"), mean_cosine("g_eff"), mean_unnormalised("mean_unnorm");
    for (const auto& row : table) {
        const PhaseFunction function = phase_in(row);
        const auto mean_of = [&](const auto& weight) {
            const auto f = [&](double c) { return weight(c) * phase(function, c); };
            return 2 * std::numbers::pi * integrate(f, -1, 1, 60);
        };
        norm.compare(row, mean_of([](double) { return 1.0; }), row.number("out.norm"), 1e-12);
        // Even scattering has 5e-32 there.
        const double g = row.number("out.g_eff");
        mean_cosine.compare(row, mean_of([](double c) { return c; }), std::abs(g) < 1e-30 ? 0 : g,
                            1e-12, 1e-15);
        // Straight back the paper's 1 + k cos^16 is 1, so that its mean is what divides it there.
        const double divisor = std::holds_alternative<HazePhase>(function)
                                   ? 1 / (4 * std::numbers::pi * phase(function, -1))
                                   : 1;
        mean_unnormalised.compare(row, divisor, row.number("out.mean_unnorm"), 1e-14);
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
