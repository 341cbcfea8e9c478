#pragma once

#include "keiko/io/toml_reader.h"

#include <cmath>

namespace keiko {

/// What multiplies the light of a source, by its key `color`.
inline Rgb color_of(const TomlTable& table) {
    return table.rgb("color", TomlLimits::not_negative()).value_or(Rgb(1));
}

/// Throws Error at the key for `light`, a product of finite numbers, beyond the largest number.
inline void require_finite(const TomlTable& table, std::string_view key, const Rgb& light) {
    if (!std::isfinite(light.r + light.g + light.b)) throw table.error(key, "is too bright");
}

} // namespace keiko
