#include "keiko/light/luminance/projected_solid_angle.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace keiko;
using std::numbers::pi;

namespace {

const std::vector<Vec3> ceiling{{-3, -2, 2}, {4, -2, 2}, {4, 5, 2}, {-3, 5, 2}};

Vec3 random_unit(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

} // namespace

TEST(PolygonIrradiance, AgreesWithOracle) {
    const test::OracleTable table("polygon_irradiance");
    test::WorstError worst("E");
    for (const auto& row : table) {
        const double omega =
            projected_solid_angle(row.points("in.V"), row.vector("in.P"), row.unit("in.N"));
        worst.compare(row, omega * row.number("in.L"), row.number("out.E"), 1e-11);
    }
}

TEST(PolygonIrradiance, DoesNotDependOnScaleOrderOrFirstCorner) {
    const Vec3 point(0.3, -0.2, 0.1), normal = Vec3(1, -0.4, 0.2).normalized();
    const double omega = projected_solid_angle(ceiling, point, normal);
    std::vector<Vec3> other(ceiling.rbegin(), ceiling.rend());
    EXPECT_NEAR(projected_solid_angle(other, point, normal), omega, 1e-15);
    for (int turn = 0; turn < 4; ++turn) {
        std::rotate(other.begin(), other.begin() + 1, other.end());
        EXPECT_NEAR(projected_solid_angle(other, point, normal), omega, 1e-15);
    }
    for (Vec3& corner : other) corner *= 1000;
    EXPECT_NEAR(projected_solid_angle(other, point * 1000, normal), omega, 1e-14);
}

TEST(PolygonIrradiance, PartsAddUpAcrossTheHorizon) {
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const Vec3 normal = random_unit(random);
        const Vec3 a = ceiling[0], b = ceiling[1], c = ceiling[2], d = ceiling[3];
        const Vec3 left = (a + d) * 0.5, right = b * 0.25 + c * 0.75;
        const std::vector<Vec3> lower{a, b, right, left}, upper{left, right, c, d};
        EXPECT_NEAR(projected_solid_angle(lower, Vec3(0), normal) +
                        projected_solid_angle(upper, Vec3(0), normal),
                    projected_solid_angle(ceiling, Vec3(0), normal), 1e-14);
    }
}

TEST(PolygonIrradiance, ClipsAConcavePolygonIntoSeveralPieces) {
    // A comb of three teeth; the horizon cuts the teeth off the back.
    const std::vector<Vec3> comb{{0, 0, 2}, {5, 0, 2}, {5, 2, 2}, {4, 2, 2}, {4, 1, 2}, {3, 1, 2},
                                 {3, 2, 2}, {2, 2, 2}, {2, 1, 2}, {1, 1, 2}, {1, 2, 2}, {0, 2, 2}};
    const Vec3 point(1.5, 1.5, 0), normal(0, 1, 0); // above the horizon: y >= 1.5
    double teeth = 0;
    for (const double x : {0.0, 2.0, 4.0}) {
        const std::vector<Vec3> tooth{{x, 1.5, 2}, {x + 1, 1.5, 2}, {x + 1, 2, 2}, {x, 2, 2}};
        teeth += projected_solid_angle(tooth, point, normal);
    }
    EXPECT_GT(teeth, 0.01);
    EXPECT_NEAR(projected_solid_angle(comb, point, normal), teeth, 1e-14);
}

TEST(PolygonIrradiance, FillsTheSkyAndVanishesBelow) {
    std::vector<Vec3> sky;
    for (int i = 0; i < 4; ++i)
        sky.emplace_back(1e9 * std::cos(i * pi / 2), 1e9 * std::sin(i * pi / 2), 1);
    EXPECT_NEAR(projected_solid_angle(sky, Vec3(0), Vec3(0, 0, 1)), pi, 1e-8);
    EXPECT_EQ(projected_solid_angle(sky, Vec3(0), Vec3(0, 0, -1)), 0);
    EXPECT_EQ(projected_solid_angle(std::vector<Vec3>{{0, 0, 1}, {1, 0, 1}}, Vec3(0), {0, 0, 1}),
              0);
}

TEST(PolygonIrradiance, VanishesSeenEdgeOn) {
    EXPECT_NEAR(projected_solid_angle(ceiling, Vec3(20, 3, 2), Vec3(-1, 0, 0)), 0, 1e-15);
}
