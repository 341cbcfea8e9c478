#include "keiko/light/fog/transmittance.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

Segment along_x(double length) {
    return {Vec3(0), {length, 0, 0}};
}

} // namespace

TEST(Transmittance, IsThatOfTheChannelAndCountsMetres) {
    const Medium medium{.extinction = {0, 0.1, 1}, .ambient = {5, 6, 7}};
    const Rgb passed = transmittance(medium, along_x(2000));
    EXPECT_EQ(passed.r, 1);
    EXPECT_DOUBLE_EQ(passed.g, std::exp(-0.2));
    EXPECT_DOUBLE_EQ(passed.b, std::exp(-2));
    const Rgb added = ambient_inscatter(medium, optical_depth(medium, along_x(2000)));
    EXPECT_EQ(added.r, 0);
    EXPECT_DOUBLE_EQ(added.g, 6 * (1 - std::exp(-0.2)));
}

TEST(Transmittance, OfLittleFogKeepsItsDigits) {
    const Medium medium{.extinction = Rgb(1e-18), .ambient = Rgb(1)};
    EXPECT_NEAR(ambient_inscatter(medium, optical_depth(medium, along_x(1000))).g, 1e-18, 1e-33);
}

TEST(Transmittance, MultipliesAlongTheWay) {
    const Medium medium{.extinction = {0.03, 0.1, 0.4}};
    const Rgb a = transmittance(medium, along_x(700)), b = transmittance(medium, along_x(4300));
    EXPECT_NEAR((a * b).g, transmittance(medium, along_x(5000)).g, 1e-15);
}

TEST(Transmittance, FarAwayTheMediumShowsItsAmbientLight) {
    const Medium medium{.extinction = Rgb(0.1), .ambient = {5, 6, 7}};
    EXPECT_EQ(transmittance(medium, along_x(1e9)), Rgb());
    EXPECT_EQ(ambient_inscatter(medium, optical_depth(medium, along_x(1e9))), Rgb(5, 6, 7));
}

TEST(Transmittance, DepthFogAgreesWithOracle) {
    const test::OracleTable table("depth_fog");
    test::WorstError worst("Cp");
    for (const auto& row : table) {
        const Vec3 fog = row.vector("in.F"), own = row.vector("in.C"), out = row.vector("out.Cp");
        const Medium medium{.extinction = Rgb(1 / row.number("in.Le")),
                            .ambient = {fog.x, fog.y, fog.z}};
        const Segment way = along_x(row.number("in.r") * 1000);
        const Rgb seen = Rgb(own.x, own.y, own.z) * transmittance(medium, way) +
                         ambient_inscatter(medium, optical_depth(medium, way));
        worst.compare(row, seen.r, out.x, 1e-11);
        worst.compare(row, seen.g, out.y, 1e-11);
        worst.compare(row, seen.b, out.z, 1e-11);
    }
}

TEST(Transmittance, OfLayersIsThatOfTheLengthsInThem) {
    const Medium medium{.extinction = {0.5, 1, 2},
                        .density = LayeredDensity{{.height = 1000}, Rgb(0.1)}};
    const Segment down{{0, 0, 3000}, {0, 0, 0}};
    EXPECT_NEAR(optical_depth(medium, down).b, 2 * 0.1 + 1 * 2.0, 1e-15);
    const Segment level{{0, 0, 1001}, {500, 0, 1001}};
    EXPECT_DOUBLE_EQ(optical_depth(medium, level).r, 0.05);
    EXPECT_EQ(extinction_at(medium, {0, 0, 999}), medium.extinction);
    EXPECT_EQ(extinction_at(medium, {0, 0, 1001}), Rgb(0.1));
}
