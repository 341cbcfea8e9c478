#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// Name of each file, for a folder: its own without the ending. Where two would be the same, each
/// is its path with "-" between folders. Throws Error naming two files that have no different
/// names.
std::vector<std::string> part_names(std::span<const std::filesystem::path> files);

} // namespace keiko
