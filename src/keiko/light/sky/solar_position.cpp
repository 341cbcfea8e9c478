#include "keiko/light/sky/solar_position.h"

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double degrees = std::numbers::pi / 180;
/// Terrestrial time less universal time in seconds, about 2020. Ten seconds move the sun by 1e-4
/// degrees.
constexpr double delta_t = 69;
/// Horizontal parallax of the sun, degrees.
constexpr double parallax = 0.0024;

/// Days from noon of 1 January 2000 [Meeus1998, ch. 7].
double days_of(const UniversalTime& time) {
    const int late = time.month > 2 ? 0 : 1; // the year begins in March
    const int year = time.year - late, month = time.month + 12 * late;
    const int century = year / 100, leap = 2 - century + century / 4;
    const double julian_date = std::floor(365.25 * (year + 4716)) +
                               std::floor(30.6001 * (month + 1)) + time.day + leap - 1524.5;
    return julian_date - 2451545 + time.hours / 24;
}

/// The sun on the celestial sphere.
struct Equatorial {
    double right_ascension, declination; ///< radians
    double sidereal_time;                ///< of Greenwich, radians
};

Equatorial equatorial(double days) {
    const double centuries = 36525;
    const double t = (days + delta_t / 86400) / centuries, tu = days / centuries;
    const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = (357.52911 + t * (35999.05029 - t * 0.0001537)) * degrees;
    const double node = (125.04 - 1934.136 * t) * degrees; // of the moon's orbit
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                          (0.019993 - 0.000101 * t) * std::sin(2 * anomaly) +
                          0.000289 * std::sin(3 * anomaly);
    const double nutation = -0.00478 * std::sin(node);
    const double longitude = (mean_longitude + centre - 0.00569 + nutation) * degrees;
    const double obliquity = (23.4392911 - 0.0130042 * t + 0.00256 * std::cos(node)) * degrees;
    const double sidereal = 280.46061837 + 360.98564736629 * days + 0.000387933 * tu * tu +
                            nutation * std::cos(obliquity);
    return {std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)),
            std::asin(std::sin(obliquity) * std::sin(longitude)),
            std::fmod(sidereal, 360) * degrees};
}

} // namespace

SolarPosition solar_position(const Site& site, const UniversalTime& time) {
    const Equatorial sun = equatorial(days_of(time));
    const double latitude = site.latitude * degrees;
    const double hour_angle = sun.sidereal_time + site.longitude * degrees - sun.right_ascension;
    // Components of the direction: towards south on the meridian, west and the zenith.
    const double across = std::cos(sun.declination) * std::cos(hour_angle);
    const double south =
        across * std::sin(latitude) - std::sin(sun.declination) * std::cos(latitude);
    const double west = std::cos(sun.declination) * std::sin(hour_angle);
    const double up = across * std::cos(latitude) + std::sin(sun.declination) * std::sin(latitude);
    const double altitude = std::atan2(up, std::hypot(south, west));
    return {altitude - parallax * degrees * std::cos(altitude),
            std::numbers::pi + std::atan2(west, south), sun.declination};
}

Vec3 direction_to_sun(const Site& site, const UniversalTime& time) {
    const SolarPosition sun = solar_position(site, time);
    const Vec3 up(0, 0, 1), north = Vec3(site.north.x, site.north.y, 0).normalized();
    const Vec3 level = north * std::cos(sun.azimuth) + north.cross(up) * std::sin(sun.azimuth);
    return level * std::cos(sun.altitude) + up * std::sin(sun.altitude);
}

} // namespace keiko
