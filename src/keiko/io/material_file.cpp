#include "keiko/io/material_file.h"

#include "keiko/base/error_text.h"
#include "keiko/base/input_file.h"
#include "keiko/io/toml_reader.h"
#include "keiko/spec/suggestion.h"

#include "keiko_standard_materials.h"

#include <algorithm>

namespace keiko {

Material material_from(const TomlTable& table) {
    Material material;
    material.name = table.text("name").value_or("");
    material.diffuse = table.required("diffuse", table.rgb("diffuse", TomlLimits::share()));
    material.refractive_index =
        table.number("refractive_index", {.low = 1}).value_or(material.refractive_index);
    table.not_yet({"flake", "roughness", "map"});
    table.finish();
    return material;
}

std::vector<Material> parse_materials(std::string_view text, const std::string& source) {
    const TomlTable root = TomlTable::parse(text, source);
    root.require_format("keiko-materials/1");
    std::vector<Material> materials;
    for (const TomlTable& table : root.tables("material")) {
        Material material = material_from(table);
        if (material.name.empty()) throw table.error("name", "a material of a file needs a name");
        if (std::any_of(materials.begin(), materials.end(),
                        [&](const Material& other) { return other.name == material.name; }))
            throw table.error("name", "'" + shortened(material.name) + "' is there twice");
        materials.push_back(std::move(material));
    }
    root.finish();
    if (materials.empty()) throw root.error("", "the file has no [[material]]");
    return materials;
}

std::vector<Material> read_materials(const std::filesystem::path& path) {
    return parse_materials(read_file(path), path.string());
}

const std::vector<Material>& standard_materials() {
    static const std::vector<Material> materials =
        parse_materials(standard_materials_toml, "materials.toml");
    return materials;
}

const Material& find_material(std::string_view name, const std::vector<Material>& materials) {
    std::vector<std::string> names;
    for (const Material& material : materials) {
        if (material.name == name) return material;
        names.push_back(material.name);
    }
    throw Error("", "",
                "unknown material '" + shortened(name) + "'" + did_you_mean(name, names) +
                    "; known are " + comma_list(names));
}

const Material& named_material(std::string_view name) {
    return find_material(name, standard_materials());
}

} // namespace keiko
