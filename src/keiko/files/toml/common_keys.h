#pragma once

#include "keiko/files/toml/toml_reader.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace keiko {

class TomlTable;

/// The file that `key` names, relative to the file of `table`; nothing when the key is absent.
/// Throws Error with file, line and column where it cannot be read.
std::optional<std::filesystem::path> path_from(const TomlTable& table, std::string_view key);

/// The file of that name, which `key` gives, relative to the file of `table`. Throws as path_from.
std::filesystem::path readable_path(const TomlTable& table, std::string_view key,
                                    const std::string& name);

/// How a TOML file in `folder` names a file; as it is where the folder is empty.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Colour that multiplies the light of a source, by its key `color`; white when absent.
Rgb color_of(const TomlTable& table);

/// Throws Error for `light`, which comes of the number at `key` and the colour, beyond what a
/// number of light may be: at the key if it is there, or else at the colour.
void require_light(const TomlTable& table, std::string_view key, const Rgb& light);

} // namespace keiko
