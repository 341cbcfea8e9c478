#pragma once

#include "keiko/scene/fixture_spec.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace keiko {

/// Reads a fixture file (keiko-fixture/1, docs/file-formats.md). Paths in it are relative to the
/// file itself. Throws Error with file, line and column.
FixtureSpec read_fixture(const std::filesystem::path& path);
/// Parses the text of a fixture; `source` is the path that messages and relative paths refer to.
FixtureSpec parse_fixture(std::string_view text, const std::string& source);

/// Name and path of a fixture, whatever its file holds.
struct FixtureFile {
    std::string name;           ///< of the file, without its extension
    std::filesystem::path file; ///< within the folder, as that was given
};

/// Every fixture of a folder, by name: its .toml files except hidden ones and those that state
/// another format of Keiko, as scenes and rigs do. Throws Error for a folder that cannot be read or
/// holds no fixture, and for a name that no fixture may have.
std::vector<FixtureFile> fixture_files(const std::filesystem::path& folder);

} // namespace keiko
