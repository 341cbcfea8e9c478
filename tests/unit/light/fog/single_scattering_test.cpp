#include "keiko/light/fog/single_scattering.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace keiko;

namespace {

PointEmitter isotropic(const Vec3& position, const Rgb& intensity) {
    return {position, [intensity](const Vec3&) { return intensity; }};
}

} // namespace

TEST(SingleScattering, AirlightAgreesWithOracle) {
    const test::OracleTable table("airlight");
    test::WorstError by_quadrature("L"), in_closed_form("L in closed form"), integral("F");
    for (const auto& row : table) {
        const Medium medium{.extinction = Rgb(row.number("in.sigma")),
                            .albedo = Rgb(row.number("in.w0"))};
        // The ray runs along x, the foot of the light at x = 0, the eye at x = -so.
        const double eye = -row.number("in.so") * 1000;
        const double begin = row.number("in.x1") * 1000, end = row.number("in.x2") * 1000;
        const Segment ray{{eye, 0, 0}, {end, 0, 0}};
        const auto lit = IntervalSet::whole((begin - eye) / (end - eye), 1);
        PointEmitter light = isotropic({0, row.number("in.h") * 1000, 0}, Rgb(row.number("in.I")));
        const auto scattered = [&] { return scattered_light({medium, ray}, lit, light).g; };
        by_quadrature.compare(row, scattered(), row.number("out.L"), 1e-8);
        light.even = light.intensity(Vec3(0));
        in_closed_form.compare(row, scattered(), row.number("out.L"), 1e-11);
        const auto xi = [&](const char* x) {
            return (std::numbers::pi / 2 + std::atan2(row.number(x), row.number("in.h"))) / 2;
        };
        integral.compare(
            row, airlight(row.number("in.sigma") * row.number("in.h"), xi("in.x1"), xi("in.x2")),
            row.number("out.F"), 1e-11);
    }
}

TEST(SingleScattering, PartsAddUpAndOrderDoesNotMatter) {
    const Medium medium{
        .extinction = {0.01, 0.2, 1}, .albedo = {0.9, 0.5, 0.3}, .phase = HazePhase{20}};
    const Segment ray{{0, 0, 0}, {9000, 300, -200}};
    const PointEmitter light = isotropic({4000, 800, 900}, {100, 200, 300});
    const IntervalSet parts({{0.1, 0.35}, {0.5, 0.52}});
    const Rgb whole = scattered_light({medium, ray}, IntervalSet::whole(), light);
    const Rgb sum = scattered_light({medium, ray}, parts, light) +
                    scattered_light({medium, ray}, parts.complement(), light);
    EXPECT_NEAR(sum.r, whole.r, 1e-8 * whole.r);
    EXPECT_NEAR(sum.b, whole.b, 1e-7 * whole.b);
    EXPECT_GT(scattered_light({medium, ray}, parts, light).g, 0);
}

TEST(SingleScattering, FogGlowsTowardsTheLamp) {
    // Before the lamp the light goes on to the eye nearly straight, behind it it must turn round.
    const Medium fog{.extinction = Rgb(1e-6), .phase = HazePhase{50}};
    const Segment ray{{0, 0, 0}, {4000, 0, 0}};
    const PointEmitter light = isotropic({2000, 100, 0}, Rgb(100));
    const double before = scattered_light({fog, ray}, IntervalSet::whole(0, 0.4), light).g;
    const double behind = scattered_light({fog, ray}, IntervalSet::whole(0.6, 1), light).g;
    EXPECT_GT(before, 0);
    EXPECT_NEAR(behind / before, 1 / 50.0, 5e-3);
}

TEST(SingleScattering, IsFiniteThroughTheLampAndZeroWithoutLength) {
    const Medium medium{.extinction = Rgb(0.1)};
    const PointEmitter light = isotropic({1000, 0, 0}, Rgb(100));
    const auto through = [&](double offset) {
        return scattered_light({medium, {{0, offset, 0}, {2000, offset, 0}}}, IntervalSet::whole(),
                               light)
            .g;
    };
    EXPECT_TRUE(std::isfinite(through(0)));
    EXPECT_DOUBLE_EQ(through(0), through(1e-6));
    EXPECT_GT(through(0), through(6));
    EXPECT_EQ(scattered_light({medium, {Vec3(0), Vec3(0)}}, IntervalSet::whole(), light), Rgb());
    EXPECT_EQ(scattered_light({medium, {Vec3(0), Vec3(1)}}, IntervalSet(), light), Rgb());
}

TEST(SingleScattering, ClosedFormIsTheQuadratureAnywhere) {
    const Segment ray{{0, 0, 0}, {8000, 100, 300}};
    for (const double sigma : {1e-9, 1e-4, 0.01, 0.3, 2.0, 40.0})
        for (const double off : {6.0, 300.0, 5000.0})
            for (const double x : {-3000.0, 1000.0, 12000.0}) {
                const Medium medium{.extinction = Rgb(sigma)};
                PointEmitter light = isotropic({x, off, 40}, Rgb(1000));
                const IntervalSet parts({{0, 0.3}, {0.42, 0.421}, {0.7, 1}});
                const double plain = scattered_light({medium, ray}, parts, light).g;
                light.even = Rgb(1000);
                EXPECT_NEAR(scattered_light({medium, ray}, parts, light).g, plain, 2e-8 * plain)
                    << sigma << " " << off << " " << x;
            }
}

TEST(SingleScattering, TheRuleOfThePapersIsNearWhereTheLampIsFar) {
    Medium medium{.extinction = Rgb(0.05), .phase = HazePhase{9}};
    const Segment ray{{0, 0, 0}, {6000, 0, 0}};
    const PointEmitter light = isotropic({3000, 3000, 0}, Rgb(1000));
    const double exact = scattered_light({medium, ray}, IntervalSet::whole(), light).g;
    medium.rule = ScatteringRule::simpson;
    const double paper = scattered_light({medium, ray}, IntervalSet::whole(), light).g;
    EXPECT_NEAR(paper, exact, 1e-4 * exact);
    EXPECT_NE(paper, exact);
}
