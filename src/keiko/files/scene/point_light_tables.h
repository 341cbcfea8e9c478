#pragma once

#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/spotlight.h"

#include <filesystem>
#include <string>

namespace keiko {

class TomlTable;

/// The lamp of a [[spotlight]]. Throws Error with file, line and column.
Spotlight spotlight_from(const TomlTable& table);
/// A [[spotlight]] that reads back as the same lamp.
std::string table_text(const Spotlight& light);

/// The lamp of a [[luminaire]], with its file read. Throws Error with file, line and column.
Luminaire luminaire_from(const TomlTable& table);
/// A [[luminaire]] that reads back as the same lamp from a rig in `folder`, which its file is named
/// relative to.
std::string table_text(const Luminaire& luminaire, const std::filesystem::path& folder);

} // namespace keiko
