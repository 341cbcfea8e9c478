#include "keiko/light/sky/solar_position.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double degrees = std::numbers::pi / 180;

UniversalTime time_of(const test::OracleRow& row) {
    return {row.integer("in.year"), row.integer("in.month"), row.integer("in.day"),
            row.integer("in.hour") + row.number("in.minute") / 60 + row.number("in.second") / 3600};
}

TEST(SolarPosition, MeetsTheOracle) {
    constexpr double tolerance = 0.01; // degrees
    for (const test::OracleRow& row : test::OracleTable("sun_position")) {
        const Site site{row.number("in.lat_deg"), row.number("in.lon_deg")};
        const SolarPosition sun = solar_position(site, time_of(row));
        const double altitude = row.number("out.alt_deg"), azimuth = row.number("out.az_deg");
        EXPECT_NEAR(sun.altitude / degrees, altitude, tolerance) << row.id();
        EXPECT_NEAR(sun.declination / degrees, row.number("out.declination_deg"), tolerance);
        const double turn = std::remainder(sun.azimuth / degrees - azimuth, 360);
        EXPECT_NEAR(turn * std::cos(sun.altitude), 0, tolerance) << row.id();
        EXPECT_GE(sun.azimuth, 0);
        const Vec3 towards = direction_to_sun(site, time_of(row));
        EXPECT_LT(angle_between(towards, row.unit("out.dir")) / degrees, tolerance) << row.id();
        EXPECT_EQ(towards.z > 0, row.integer("out.up") == 1) << row.id();
    }
}

TEST(SolarPosition, TurnsWithTheNorthOfTheScene) {
    const UniversalTime noon{2026, 6, 21, 12};
    const Vec3 towards = direction_to_sun({50, 8.3}, noon);
    const Vec3 turned = direction_to_sun({50, 8.3, {-3, 0, 1}}, noon);
    EXPECT_NEAR(turned.x, -towards.y, 1e-15); // north is -x, so east is y
    EXPECT_NEAR(turned.y, towards.x, 1e-15);
    EXPECT_NEAR(turned.z, towards.z, 1e-15);
}

/// Times past midnight are on the day after, over the end of a month and of a leap February too.
TEST(SolarPosition, HoursBeyondADayAreOnAnother) {
    const auto same = [](const UniversalTime& a, const UniversalTime& b) {
        const Site site{-33, 151};
        return (direction_to_sun(site, a) - direction_to_sun(site, b)).length() < 1e-9;
    };
    EXPECT_TRUE(same({2026, 12, 31, 26}, {2027, 1, 1, 2}));
    EXPECT_TRUE(same({2028, 3, 1, -3}, {2028, 2, 29, 21}));
    EXPECT_FALSE(same({2027, 3, 1, -3}, {2027, 2, 27, 21}));
}

} // namespace
} // namespace keiko
