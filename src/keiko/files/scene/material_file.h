#pragma once

#include "keiko/base/export.h"
#include "keiko/scene/material.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

class TomlTable;

/// Reads a materials file (keiko-materials/1, docs/scene-format.md). Throws Error with file, line
/// and column.
std::vector<Material> read_materials(const std::filesystem::path& path);
/// Parses the text of a materials file; `source` is the file name for messages.
std::vector<Material> parse_materials(std::string_view text, const std::string& source);
/// The material whose keys a table holds.
Material material_from(const TomlTable& table);

/// The materials of lightrigs/materials.toml as they were when the program was built. The first is
/// the default.
const std::vector<Material>& standard_materials();
/// Material of a name among `materials`; throws Error naming the known ones.
const Material& find_material(std::string_view name, const std::vector<Material>& materials);
/// Standard material of a name; throws Error naming the known ones.
const Material& named_material(std::string_view name);

} // namespace keiko
