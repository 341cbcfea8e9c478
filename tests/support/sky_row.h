#pragma once

#include "keiko/light/sky/sky_light.h"

#include "tests/support/oracle.h"

#include <cmath>
#include <numbers>

namespace keiko::test {

/// The sky of a row of the oracle tables sky and sky_window, with the sun at an elevation and an
/// azimuth from x towards y, radians.
inline SkyLight sky_of(const OracleRow& row, double elevation, double azimuth) {
    const std::string kind = row.text("in.kind");
    SkyLight sky;
    sky.model = kind == "uniform"    ? SkyModel::uniform
                : kind == "overcast" ? SkyModel::overcast
                                     : SkyModel::clear;
    sky.luminance = Rgb(row.number("in.Lz"));
    sky.sun = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
               std::sin(elevation)};
    return sky;
}

/// The sky of a row of sky_window behind its window, a parallelogram with the sides a and b.
inline SkyLight sky_of_window(const OracleRow& row, const Vec3& a, const Vec3& b) {
    constexpr double degrees = std::numbers::pi / 180;
    SkyLight sky = sky_of(row, row.number("in.sun_el_deg") * degrees,
                          std::numbers::pi / 2 - row.number("in.sun_az_deg") * degrees);
    const Vec3 c = row.vector("in.c");
    sky.windows = {{{c, c + a, c + a + b, c + b}}};
    return sky;
}

} // namespace keiko::test
