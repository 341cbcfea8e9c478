#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/luminance/photometry.h"

#include <array>
#include <numbers>

namespace keiko {
namespace {

constexpr std::array<std::string_view, 3> distributions{"uniform", "cardioid", "power"};

/// Intensity by its own key or by the flux; `unit_flux` is that of one unit of intensity.
Rgb intensity_from(const TomlTable& table, const Rgb& otherwise, double unit_flux) {
    const auto intensity = table.rgb("intensity", TomlLimits::light());
    const auto flux = table.number("luminous_flux", TomlLimits::light());
    if (intensity && flux)
        throw table.error("luminous_flux", "give either intensity or luminous_flux, not both");
    const Rgb own = flux ? Rgb(*flux / unit_flux) : intensity.value_or(otherwise);
    const Rgb colored = own * color_of(table);
    require_light(table, flux ? "luminous_flux" : "intensity", colored);
    return colored;
}

} // namespace

PointSource point_from(const TomlTable& table) {
    PointSource light;
    light.position = table.required("position", table.vector("position"));
    light.axis = table.vector("axis").value_or(light.axis);
    if (!(light.axis.length() > 0)) throw table.error("axis", "must not be a zero vector");
    if (const auto word =
            table.choice("distribution", {distributions[0], distributions[1], distributions[2]}))
        light.distribution = static_cast<PointDistribution>(*word);
    const auto exponent = table.number("exponent", {.low = 0, .high = 1e6});
    if (light.distribution == PointDistribution::power)
        light.exponent = table.required("exponent", exponent);
    else if (exponent)
        throw table.error("exponent", "belongs to distribution = \"power\" alone");
    light.intensity = intensity_from(table, light.intensity, flux_of_unit_intensity(light));
    light.shaft = table.flag("shaft").value_or(light.shaft);
    table.finish();
    return light;
}

std::string table_text(const PointSource& light) {
    const PointSource plain;
    std::string text = "\n[[point]]\n" + toml_line("position", toml_value(light.position), "mm");
    if (light.axis != plain.axis) text += toml_line("axis", toml_value(light.axis));
    if (light.distribution != plain.distribution) {
        const auto word = distributions[static_cast<std::size_t>(light.distribution)];
        text += toml_line("distribution", toml_string(word));
    }
    if (light.distribution == PointDistribution::power)
        text += toml_line("exponent", toml_value(light.exponent));
    if (!light.shaft) text += toml_line("shaft", "false");
    return text + toml_line("intensity", toml_value(light.intensity), "cd");
}

LineLight line_from(const TomlTable& table) {
    constexpr double pi = std::numbers::pi;
    LineLight light;
    light.a = table.required("a", table.vector("a"));
    light.b = table.required("b", table.vector("b"));
    const double length = metres((light.b - light.a).length());
    if (!(length > 0)) throw table.error("b", "must differ from a");
    light.intensity = intensity_from(table, light.intensity, pi * pi * length);
    table.finish();
    return light;
}

std::string table_text(const LineLight& light) {
    std::string text = "\n[[line]]\n" + toml_line("a", toml_value(light.a), "mm");
    text += toml_line("b", toml_value(light.b), "mm");
    return text + toml_line("intensity", toml_value(light.intensity), "cd/m across it");
}

} // namespace keiko
