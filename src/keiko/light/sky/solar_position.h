#pragma once

#include "keiko/math/vec.h"

namespace keiko {

/// A place on the earth, and the orientation of a scene there, whose z axis points up.
struct Site {
    double latitude = 0;  ///< degrees, -90 to 90, north positive
    double longitude = 0; ///< degrees, -180 to 180, east positive
    Vec3 north{0, 1, 0};  ///< direction of north; its part along z does not count
};

/// Universal time in the Gregorian calendar.
struct UniversalTime {
    int year = 2000, month = 1, day = 1; ///< date
    /// Hours after midnight; other than 0 to 24 it is on another day.
    double hours = 0;
};

/// Place of the sun in the sky.
struct SolarPosition {
    double altitude = 0;    ///< radians above the horizon, of its centre, without refraction
    double azimuth = 0;     ///< radians clockwise from north, 0 to 2 pi
    double declination = 0; ///< radians
};

/// Position of the sun [Meeus1998, ch. 25, low accuracy] (docs/theory/sky.md#the-sun), to 0.01
/// degrees for the years 1900 to 2100.
SolarPosition solar_position(const Site& site, const UniversalTime& time);

/// Unit vector towards the sun in the axes of the scene.
Vec3 direction_to_sun(const Site& site, const UniversalTime& time);

} // namespace keiko
