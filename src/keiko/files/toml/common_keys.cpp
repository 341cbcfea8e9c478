#include "keiko/files/toml/common_keys.h"

#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/toml/toml_reader.h"

namespace keiko {

std::optional<std::filesystem::path> path_from(const TomlTable& table, std::string_view key) {
    const auto name = table.text(key);
    if (!name) return {};
    return readable_path(table, key, *name);
}

std::filesystem::path readable_path(const TomlTable& table, std::string_view key,
                                    const std::string& name) {
    const auto path = (table.source().parent_path() / name).lexically_normal();
    try {
        require_readable_file(path);
    } catch (const Error& error) {
        throw table.error(key, shortened(error.what()));
    }
    return path;
}

std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
    return (folder.empty() ? file : file.lexically_proximate(folder)).generic_string();
}

Rgb color_of(const TomlTable& table) {
    return table.rgb("color", TomlLimits::light()).value_or(Rgb(1));
}

void require_light(const TomlTable& table, std::string_view key, const Rgb& light) {
    const double most = TomlLimits::light().high;
    if (light.r <= most && light.g <= most && light.b <= most) return;
    const bool colored = table.has("color");
    throw table.error(table.has(key) || !colored ? key : "color",
                      colored ? "is too bright, times the color" : "is too bright");
}

} // namespace keiko
