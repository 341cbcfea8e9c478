#include "keiko/light/luminance/projected_solid_angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace keiko;
using std::numbers::pi;

namespace {

/// The polygon of equal area with many corners.
double by_polygon(const Disc& disc, const Vec3& point, const Vec3& normal) {
    constexpr int corners = 4000;
    const double step = 2 * pi / corners, radius = disc.radius * std::sqrt(step / std::sin(step));
    const Vec3 x = disc.normal.cross(Vec3(0.36, 0.48, 0.8)).normalized(), y = disc.normal.cross(x);
    std::vector<Vec3> rim;
    for (int i = 0; i < corners; ++i)
        rim.push_back(disc.center + (x * std::cos(i * step) + y * std::sin(i * step)) * radius);
    return projected_solid_angle(rim, point, normal);
}

} // namespace

TEST(DiscIrradiance, IsThatOfAPolygonOfManyCornersInAnyPosition) {
    std::mt19937 random(11);
    std::normal_distribution<double> any;
    const auto direction = [&] { return Vec3(any(random), any(random), any(random)).normalized(); };
    int cut = 0;
    for (int i = 0; i < 200; ++i) {
        const Disc disc{direction() * (0.3 + std::abs(any(random))), direction(), 1};
        const Vec3 normal = direction();
        cut += std::abs(normal.dot(disc.center)) < 0.8;
        EXPECT_NEAR(projected_solid_angle(disc, Vec3(0), normal), by_polygon(disc, Vec3(0), normal),
                    4e-6);
    }
    EXPECT_GT(cut, 50);
}

TEST(DiscIrradiance, HasTheClosedFormOfACoaxialDisc) {
    for (const double height : {1e-3, 0.5, 7.0, 1e4}) {
        const double omega =
            projected_solid_angle(Disc{{0, 0, height}, {0, 0, 1}, 2}, Vec3(0), Vec3(0, 0, 1));
        EXPECT_NEAR(omega, pi * 4 / (4 + height * height), 1e-13 * omega);
    }
}

/// On the axis of a disc aslant the direction to its middle is all rounding.
TEST(DiscIrradiance, IsThatOfAPolygonFromItsOwnAxis) {
    std::mt19937 random(12);
    std::normal_distribution<double> any;
    const auto direction = [&] { return Vec3(any(random), any(random), any(random)).normalized(); };
    int cut = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 axis = direction(), normal = direction();
        const Disc disc{axis * 0.8, axis, 1};
        cut += std::abs(normal.dot(axis)) < 0.7;
        EXPECT_NEAR(projected_solid_angle(disc, Vec3(0), normal), by_polygon(disc, Vec3(0), normal),
                    4e-6);
    }
    EXPECT_GT(cut, 50);
}

TEST(DiscIrradiance, PartsOfTheSkyAddUpWhereTheHorizonCuts) {
    // Seen from a point, opposite normals share the disc between them; along the cut both count.
    const Disc disc{{0.01, 0.02, 0.8}, {0, 0, 1}, 1};
    const Vec3 normal = Vec3(1, 0.2, 0.05).normalized();
    const Vec3 towards = Vec3(0, 0, 1);
    const double above = projected_solid_angle(disc, Vec3(0), normal);
    const double below = projected_solid_angle(disc, Vec3(0), -normal);
    EXPECT_NEAR(above, by_polygon(disc, Vec3(0), normal), 1e-6);
    EXPECT_NEAR(below, by_polygon(disc, Vec3(0), -normal), 1e-6);
    EXPECT_GT(projected_solid_angle(disc, Vec3(0), towards), above);
}

TEST(DiscIrradiance, VanishesBelowTheHorizonEdgeOnAndWithoutExtent) {
    const Vec3 up(0, 0, 1);
    EXPECT_EQ(projected_solid_angle(Disc{{0, 0, -3}, up, 1}, Vec3(0), up), 0);
    EXPECT_NEAR(projected_solid_angle(Disc{{5, 0, 2}, {0, 1, 0}, 1}, Vec3(0), up), 0, 1e-16);
    EXPECT_EQ(projected_solid_angle(Disc{{0, 0, 3}, up, 0}, Vec3(0), up), 0);
}
