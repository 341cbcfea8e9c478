#pragma once

#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

class TomlTable;

/// Reads a rig file (keiko-rig/1, docs/scene-format.md). Throws Error with file, line and column.
LightRig read_rig(const std::filesystem::path& path);
/// Parses the text of a rig file; `source` is the file name for messages.
LightRig parse_rig(std::string_view text, const std::string& source);
/// Parses the text of a rig file from elsewhere. Throws Error as parse_rig, and for a key that
/// names a file, whether there is such a file or not.
LightRig parse_rig_alone(std::string_view text, const std::string& source);
/// The rig whose keys stand among others in `table`: name, ambient, [[c_plane]], [[spotlight]],
/// [[luminaire]], [[polygon]], [[sphere]], [[box]], [[sign]], [[point]], [[line]], [sun], [sky],
/// [place], [[window]], [fog].
LightRig rig_from(const TomlTable& table);

/// The text of a rig file: every number reads back as the same double, units are named in
/// comments, and the same rig always gives the same text. Lights of bodies are left out. Files of
/// luminaires are named relative to `folder`, if there is one. Throws Error for a rig that no file
/// can hold, e.g. with numbers that are not finite.
std::string rig_text(const LightRig& rig, const std::filesystem::path& folder = {});
/// Writes a rig file, atomically. Throws Error when it cannot.
void write_rig(const std::filesystem::path& path, const LightRig& rig);

} // namespace keiko
