#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_document.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/light/sky/solar_position.h"
#include "keiko/math/polygon.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace keiko {
namespace {

/// Sine of an angle to a window's plane below which the sun shines along it.
constexpr double along_plane = 1e-6;
/// Years for which the position of the sun is accurate.
constexpr int first_year = 1900, last_year = 2100;
/// Largest luminance at the horizon of a gradient, by that at the zenith.
constexpr double brightest_horizon = 1000;
constexpr std::array<std::string_view, 4> models{"uniform", "overcast", "gradient", "clear"};

Site site_from(const TomlTable& table) {
    Site site;
    const auto latitude = table.number("latitude", {.low = -90, .high = 90});
    const auto longitude = table.number("longitude", {.low = -180, .high = 180});
    site.latitude = table.required("latitude", latitude);
    site.longitude = table.required("longitude", longitude);
    site.north = table.vector("north").value_or(site.north);
    if (!(std::hypot(site.north.x, site.north.y) > 0))
        throw table.error("north", "must not be vertical");
    return site;
}

UniversalTime time_from(const TomlTable& table) {
    const TomlDateTime time = table.required("time", table.date_time("time"));
    if (time.year < first_year || time.year > last_year)
        throw table.error("time", "must be from the years " + std::to_string(first_year) + " to " +
                                      std::to_string(last_year));
    return {time.year, time.month, time.day, time.hours - *time.offset};
}

/// The luminance of a sky at the zenith, by its own key or by the illuminance that it causes.
Rgb luminance_from(const TomlTable& table, const SkyLight& sky) {
    const auto luminance = table.rgb("luminance", TomlLimits::light());
    const auto lx = table.number("illuminance", TomlLimits::light());
    if (luminance && lx)
        throw table.error("illuminance", "give either luminance or illuminance, not both");
    const Rgb own = lx ? Rgb(*lx / unobstructed_illuminance(sky, {0, 0, 1}))
                       : luminance.value_or(sky.luminance);
    const Rgb colored = own * color_of(table);
    require_light(table, lx ? "illuminance" : "luminance", colored);
    return colored;
}

/// Direction towards the sun of a clear sky.
Vec3 sun_of(const TomlTable& table, const std::optional<Vec3>& sun) {
    const auto own = table.vector("sun");
    if (!own && !sun) throw table.error("model", "a clear sky needs sun, [sun] or [place]");
    const Vec3 towards = own.value_or(sun.value_or(Vec3(0)));
    if (!(towards.z > 0)) throw table.error(own ? "sun" : "", "the sun is not above the horizon");
    return towards;
}

Window window_from(const TomlTable& table, const std::optional<Vec3>& sun) {
    Window window{corners_from(table)};
    table.finish();
    require_ring(table, window.corners);
    const Vec3 normal = polygon_normal(window.corners);
    if (sun && !(std::abs(normal.dot(*sun)) > along_plane * normal.length() * sun->length()))
        throw table.error("corners", "the sun must not shine along the window");
    return window;
}

} // namespace

Vec3 direction_to_sun_from(const TomlTable& place) {
    const Site site = site_from(place);
    const UniversalTime time = time_from(place);
    place.finish();
    const double altitude = solar_position(site, time).altitude * 180 / std::numbers::pi;
    if (!(altitude > 0)) {
        std::array<char, 64> text{};
        std::snprintf(text.data(), text.size(), "the sun is %.1f degrees below the horizon",
                      -altitude);
        throw place.error("time", text.data());
    }
    return direction_to_sun(site, time);
}

std::vector<Window> windows_from(const std::vector<TomlTable>& tables,
                                 const std::optional<Vec3>& sun) {
    std::vector<Window> windows;
    for (const TomlTable& table : tables) windows.push_back(window_from(table, sun));
    return windows;
}

Sun sun_from(const TomlTable& table, const std::optional<Vec3>& towards) {
    Sun sun;
    const auto own = table.vector("direction");
    if (own && towards)
        throw table.error("direction", "give either direction or [place], not both");
    sun.direction = towards ? -*towards : table.required("direction", own);
    if (!(sun.direction.length() > 0)) throw table.error("direction", "must not be a zero vector");
    sun.illuminance = table.required("illuminance", table.rgb("illuminance", TomlLimits::light())) *
                      color_of(table);
    require_light(table, "illuminance", sun.illuminance);
    sun.shaft = table.flag("shaft").value_or(sun.shaft);
    table.finish();
    return sun;
}

SkyLight sky_light_from(const TomlTable& table, const std::optional<Vec3>& sun) {
    SkyLight sky;
    if (const auto model = table.choice("model", {models[0], models[1], models[2], models[3]}))
        sky.model = static_cast<SkyModel>(*model);
    const auto horizon = table.number("horizon", {.low = 0, .high = brightest_horizon});
    if (sky.model == SkyModel::gradient)
        sky.horizon = table.required("horizon", horizon);
    else if (horizon)
        throw table.error("horizon", "belongs to a gradient");
    if (sky.model == SkyModel::clear)
        sky.sun = sun_of(table, sun);
    else if (table.has("sun"))
        throw table.error("sun", "belongs to a clear sky");
    sky.luminance = luminance_from(table, sky);
    sky.ground = table.rgb("ground", TomlLimits::light()).value_or(sky.ground);
    table.finish();
    return sky;
}

std::string table_text(const Sun& sun) {
    std::string text = "\n[sun]\n";
    text += toml_line("direction", toml_value(sun.direction), "the way the light goes");
    text += toml_line("illuminance", toml_value(sun.illuminance), "lx across the light");
    if (!sun.shaft) text += toml_line("shaft", "false");
    return text;
}

std::string table_text(const SkyLight& sky) {
    std::string text = "\n[sky]\n";
    text += toml_line("model", toml_string(models[static_cast<std::size_t>(sky.model)]));
    text += toml_line("luminance", toml_value(sky.luminance), "cd/m2 at the zenith");
    if (sky.model == SkyModel::gradient)
        text += toml_line("horizon", toml_value(sky.horizon), "by the luminance at the zenith");
    if (sky.model == SkyModel::clear)
        text += toml_line("sun", toml_value(sky.sun), "towards the sun");
    if (sky.ground != Rgb(0)) text += toml_line("ground", toml_value(sky.ground), "cd/m2");
    return text;
}

std::string windows_text(const std::vector<Window>& windows) {
    std::string text;
    for (const Window& window : windows) text += "\n[[window]]\n" + corners_line(window.corners);
    return text;
}

} // namespace keiko
