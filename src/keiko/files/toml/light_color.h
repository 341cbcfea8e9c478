#pragma once

#include "keiko/files/toml/toml_reader.h"

namespace keiko {

/// What multiplies the light of a source, by its key `color`.
inline Rgb color_of(const TomlTable& table) {
    return table.rgb("color", TomlLimits::light()).value_or(Rgb(1));
}

/// Throws Error for `light`, which comes of the number at `key` and the colour, beyond what a
/// number of light may be: at the key if it is there, or else at the colour.
inline void require_light(const TomlTable& table, std::string_view key, const Rgb& light) {
    const double most = TomlLimits::light().high;
    if (light.r <= most && light.g <= most && light.b <= most) return;
    const bool colored = table.has("color");
    throw table.error(table.has(key) || !colored ? key : "color",
                      colored ? "is too bright, times the color" : "is too bright");
}

} // namespace keiko
