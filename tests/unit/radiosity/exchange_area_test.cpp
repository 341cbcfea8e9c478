#include "keiko/radiosity/exchange_area.h"

#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/radiosity/triangle_cubature.h"

#include "tests/support/oracle.h"
#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace keiko {
namespace {

using test::area_of;
using test::parallelogram;

/// The rectangle of a row, facing a place.
std::vector<Vec3> rectangle(const test::OracleRow& row, const std::string& number,
                            const Vec3& towards) {
    const Vec3 corner = row.vector("in.c" + number);
    const Vec3 u = row.vector("in.a" + number), v = row.vector("in.b" + number);
    const bool faces = u.cross(v).dot(towards - corner) > 0;
    return faces ? parallelogram(corner, u, v) : parallelogram(corner, v, u);
}

TEST(ExchangeArea, OfRectanglesIsThatOfTheOracle) {
    test::WorstError error("F12");
    for (const test::OracleRow& row : test::OracleTable("form_factor")) {
        const Vec3 near = row.vector("in.c1"), far = row.vector("in.c2");
        const Vec3 a = row.vector("in.a1"), b = row.vector("in.b1");
        const Vec3 c = row.vector("in.a2"), d = row.vector("in.b2");
        const auto first = rectangle(row, "1", far + (c + d) / 2);
        const auto second = rectangle(row, "2", near + (a + b) / 2);
        const double factor = direct_exchange_area(first, second) / area_of(first);
        error.compare(row, factor, row.number("out.F12"), 1e-10);
    }
}

/// A triangle of any place and size.
std::vector<Vec3> random_triangle(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1, 1), size(0.1, 1);
    const Vec3 middle(place(random) * 2, place(random) * 2, place(random) * 2);
    const double scale = size(random);
    std::vector<Vec3> corners;
    for (int i = 0; i < 3; ++i)
        corners.push_back(middle + Vec3(place(random), place(random), place(random)) * scale);
    return corners;
}

/// True if no triangle crosses the plane of the other, which polygons that cross must do.
bool apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    const Vec3 n = polygon_normal(a);
    int before = 0;
    for (const Vec3& corner : b) before += n.dot(corner - a[0]) > 0 ? 1 : 0;
    return before == 0 || before == 3;
}

// Two implementations: twice Stokes' theorem, and Lambert's sum integrated over the other.
TEST(ExchangeArea, IsTheIntegralOfTheFormFactorOfPoints) {
    std::mt19937 random(1);
    int lit = 0, clipped = 0;
    for (int i = 0; i < 300; ++i) {
        const auto a = random_triangle(random), b = random_triangle(random);
        if (!apart(a, b)) continue;
        const double exchange = direct_exchange_area(a, b);
        const Vec3 normal = polygon_normal(a).normalized(), other = polygon_normal(b);
        const auto factor = [&](const Vec3& point) {
            if (!(other.dot(point - b[0]) > 0)) return 0.0;
            return projected_solid_angle(b, point, normal) / std::numbers::pi;
        };
        const CubatureSum sum = integrate_adaptively_over(a, factor, 1e-7 * area_of(a), 4000);
        EXPECT_NEAR(exchange, sum.value, 2e-6 * area_of(a)) << i;
        lit += exchange > 1e-3 * area_of(a) ? 1 : 0;
        clipped += part_before(a, b[0], other).size() > 3 ? 1 : 0;
    }
    EXPECT_GT(lit, 20);
    EXPECT_GT(clipped, 5);
}

TEST(ExchangeArea, IsTheSameFromBothSides) {
    std::mt19937 random(2);
    int lit = 0;
    for (int i = 0; i < 300; ++i) {
        const auto a = random_triangle(random), b = random_triangle(random);
        if (!apart(a, b) && !apart(b, a)) continue;
        const double one = direct_exchange_area(a, b), other = direct_exchange_area(b, a);
        EXPECT_NEAR(one, other, 1e-8 * std::max(one, 1e-4 * area_of(a))) << i;
        lit += one > 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 50);
}

TEST(ExchangeArea, DoesNotDependOnTheUnit) {
    const auto at = [](double scale) {
        const auto a = parallelogram(Vec3(0), Vec3(scale, 0, 0), Vec3(0, scale, 0));
        const auto b = parallelogram(Vec3(0), Vec3(0, scale, 0), Vec3(0, 0, scale));
        return direct_exchange_area(a, b) / area_of(a);
    };
    EXPECT_NEAR(at(1e4), at(1), 1e-11);
    EXPECT_NEAR(at(1), 0.20004377607540316, 1e-11); // of neighbouring faces of a cube
}

TEST(ExchangeArea, OfFarElementsIsThatOfPoints) {
    for (const double distance : {3.0, 10.0, 50.0, 1000.0, 1e5}) {
        const auto a = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
        const auto b = parallelogram(Vec3(0, 0, distance), Vec3(0, 1, 0), Vec3(1, 0, 0));
        const double far = 1 / (std::numbers::pi * distance * distance);
        const double second_order = 1 / (distance * distance);
        EXPECT_NEAR(direct_exchange_area(a, b) / far, 1, second_order + 1e-4) << distance;
    }
}

TEST(ExchangeArea, IsNothingBehindInAPlaneAndWithoutArea) {
    const auto a = parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    const auto behind = parallelogram(Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0));
    const auto beside = parallelogram(Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    const auto back = parallelogram(Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_EQ(direct_exchange_area(a, behind), 0);
    EXPECT_LE(direct_exchange_area(a, beside), 1e-12);
    EXPECT_EQ(direct_exchange_area(a, back), 0);
    EXPECT_EQ(direct_exchange_area(a, std::vector<Vec3>{Vec3(0), Vec3(1, 1, 1)}), 0);
}

} // namespace
} // namespace keiko
