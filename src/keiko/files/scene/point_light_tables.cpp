#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/files/photometric/luminaire_file.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/spotlight/luminous_flux.h"

namespace keiko {
namespace {

/// Factor from the lamp's own flux to `flux`, both in lm.
Rgb flux_factor(const TomlTable& table, double flux, double own) {
    if (!(own > 0)) throw table.error("luminous_flux", "the lamp is dark into all directions");
    return Rgb(flux / own);
}

/// Tables hold cd themselves; all others take the intensity of the struct.
Rgb intensity_from(const TomlTable& table, const Spotlight& light) {
    const auto intensity = table.rgb("intensity", TomlLimits::light());
    const auto flux = table.number("luminous_flux", TomlLimits::light());
    if (intensity && flux)
        throw table.error("luminous_flux", "give either intensity or luminous_flux, not both");
    if (flux) {
        Spotlight unit = light;
        unit.intensity = Rgb(1);
        return flux_factor(table, *flux, luminance(luminous_flux(unit)));
    }
    const bool has_table = std::holds_alternative<TableProfile>(light.profile);
    return intensity.value_or(has_table ? Rgb(1) : light.intensity);
}

Vec3 direction_from(const TomlTable& table, std::string_view key, const Vec3& otherwise) {
    const Vec3 direction = table.vector(key).value_or(otherwise);
    if (!(direction.length() > 0)) throw table.error(key, "must not be a zero vector");
    return direction;
}

std::shared_ptr<const PhotometricWeb> web_from(const TomlTable& table,
                                               const std::filesystem::path& path) {
    try {
        return std::make_shared<const PhotometricWeb>(read_luminaire(path));
    } catch (const Error& error) {
        throw table.error("file", shortened(error.what()));
    }
}

} // namespace

Spotlight spotlight_from(const TomlTable& table) {
    Spotlight light;
    light.position = table.required("position", table.vector("position"));
    light.aim = table.required("aim", table.vector("aim"));
    if (light.aim == light.position) throw table.error("aim", "must differ from position");
    light.reference = direction_from(table, "reference", light.reference);
    light.spin = table.number("spin", {.low = -1e6, .high = 1e6}).value_or(light.spin);
    take_beam(table, light);
    light.intensity = intensity_from(table, light) * color_of(table);
    require_light(table, table.has("luminous_flux") ? "luminous_flux" : "intensity",
                  light.intensity);
    light.shaft = table.flag("shaft").value_or(light.shaft);
    table.finish();
    return light;
}

std::string table_text(const Spotlight& light) {
    const Spotlight plain;
    std::string text = "\n[[spotlight]]\n";
    text += toml_line("position", toml_value(light.position), "mm");
    text += toml_line("aim", toml_value(light.aim), "mm");
    if (light.reference != plain.reference)
        text += toml_line("reference", toml_value(light.reference), "direction of phi = 0");
    if (light.spin != plain.spin)
        text += toml_line("spin", toml_value(light.spin), "degrees added to phi");
    text += beam_text(light);
    if (!light.shaft) text += toml_line("shaft", "false");
    return text + toml_line("intensity", toml_value(light.intensity), "cd");
}

Luminaire luminaire_from(const TomlTable& table) {
    Luminaire lamp;
    const auto path = table.required("file", path_from(table, "file"));
    lamp.file = path.string();
    lamp.web = web_from(table, path);
    const bool head_lamp = lamp.web->type == PhotometricType::a;
    lamp.position = table.required("position", table.vector("position"));
    const auto aim = table.vector("aim");
    lamp.aim =
        head_lamp ? table.required("aim", aim) : aim.value_or(lamp.position + Vec3(0, 0, -1));
    if (lamp.aim == lamp.position) throw table.error("aim", "must differ from position");
    lamp.reference = direction_from(table, "reference", head_lamp ? Vec3(0, 0, 1) : lamp.reference);
    lamp.spin = table.number("spin", {.low = -1e6, .high = 1e6}).value_or(lamp.spin);
    lamp.flip_h = table.flag("flip_h").value_or(lamp.flip_h);
    const auto dimming = table.number("dimming", TomlLimits::light());
    const auto flux = table.number("luminous_flux", TomlLimits::light());
    if (dimming && flux)
        throw table.error("luminous_flux", "give either dimming or luminous_flux, not both");
    lamp.factor =
        flux ? flux_factor(table, *flux, luminous_flux(*lamp.web)) : Rgb(dimming.value_or(1));
    lamp.factor *= color_of(table);
    require_light(table, flux ? "luminous_flux" : "dimming",
                  lamp.factor * lamp.web->candela.largest());
    lamp.shaft = table.flag("shaft").value_or(lamp.shaft);
    table.finish();
    return lamp;
}

std::string table_text(const Luminaire& lamp, const std::filesystem::path& folder) {
    const Luminaire plain;
    std::string text = "\n[[luminaire]]\n";
    text += toml_line("file", toml_string(named_from(folder, lamp.file)));
    text += toml_line("position", toml_value(lamp.position), "mm");
    text += toml_line("aim", toml_value(lamp.aim), "mm");
    text += toml_line("reference", toml_value(lamp.reference), "direction of H = 0, or up");
    if (lamp.spin != plain.spin) text += toml_line("spin", toml_value(lamp.spin), "degrees");
    if (lamp.flip_h) text += toml_line("flip_h", "true");
    if (!lamp.shaft) text += toml_line("shaft", "false");
    return text + toml_line("color", toml_value(lamp.factor), "times the file's cd");
}

} // namespace keiko
