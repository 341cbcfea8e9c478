#pragma once

#include "keiko/light/fog/medium.h"

#include <filesystem>
#include <string>

namespace keiko {

class TomlTable;

/// The medium of [fog]. Throws Error with file, line and column.
Medium medium_from(const TomlTable& table);
/// A [fog] that reads back as the same medium from a rig in `folder`, which the file of a density
/// is named relative to.
std::string table_text(const Medium& medium, const std::filesystem::path& folder);

} // namespace keiko
