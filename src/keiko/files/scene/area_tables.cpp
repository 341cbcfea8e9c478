#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/polygon.h"

#include <numbers>

namespace keiko {

Rgb luminance_from(const TomlTable& table, const Rgb& otherwise,
                   const std::function<double(double)>& of_flux) {
    const auto luminance = table.rgb("luminance", TomlLimits::light());
    const auto flux = table.number("luminous_flux", TomlLimits::light());
    if (luminance && flux)
        throw table.error("luminous_flux", "give either luminance or luminous_flux, not both");
    const Rgb own = flux ? Rgb(of_flux(*flux)) : luminance.value_or(otherwise);
    const Rgb colored = own * color_of(table);
    require_light(table, flux ? "luminous_flux" : "luminance", colored);
    return colored;
}

namespace {

/// Luminance of a diffuse source of `area` mm2.
Rgb luminance_of_area(const TomlTable& table, const Rgb& otherwise, double area) {
    return luminance_from(table, otherwise,
                          [area](double flux) { return diffuse_luminance(flux, area); });
}

} // namespace

PolygonLight polygon_keys_from(const TomlTable& table) {
    PolygonLight light;
    light.corners = corners_from(table);
    light.two_sided = table.flag("two_sided").value_or(light.two_sided);
    require_ring(table, light.corners);
    const double area = polygon_normal(light.corners).length() / 2 * (light.two_sided ? 2 : 1);
    light.luminance = luminance_of_area(table, light.luminance, area);
    return light;
}

PolygonLight polygon_light_from(const TomlTable& table) {
    PolygonLight light = polygon_keys_from(table);
    table.tables("map"); // none, but a misspelt one is corrected
    table.finish();
    return light;
}

std::string table_text(const PolygonLight& light) {
    std::string text = "\n[[polygon]]\n" + corners_line(light.corners);
    if (light.two_sided) text += toml_line("two_sided", "true");
    return text + toml_line("luminance", toml_value(light.luminance), "cd/m2");
}

SphereLight sphere_light_from(const TomlTable& table) {
    SphereLight light;
    light.center = table.required("center", table.vector("center"));
    light.radius = table.required("radius", table.number("radius", TomlLimits::length()));
    const double area = 4 * std::numbers::pi * light.radius * light.radius;
    light.luminance = luminance_of_area(table, light.luminance, area);
    table.finish();
    return light;
}

std::string table_text(const SphereLight& light) {
    std::string text = "\n[[sphere]]\n";
    text += toml_line("center", toml_value(light.center), "mm");
    text += toml_line("radius", toml_value(light.radius), "mm");
    return text + toml_line("luminance", toml_value(light.luminance), "cd/m2");
}

} // namespace keiko
