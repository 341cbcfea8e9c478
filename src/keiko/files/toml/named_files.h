#pragma once

#include <filesystem>
#include <vector>

namespace keiko {

/// A TOML file and every file that it names: each text in it that is the path of a regular file
/// relative to its folder, and, where that is a TOML file too, what that one names. Sorted, each
/// once. A superset of what reading it takes, whatever its format. Throws Error for a file that
/// cannot be parsed.
std::vector<std::filesystem::path> files_named_by(const std::filesystem::path& toml_file);

} // namespace keiko
