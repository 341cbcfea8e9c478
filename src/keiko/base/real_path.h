#pragma once

#include <filesystem>

namespace keiko {

/// The absolute path without links, also of a file that does not exist.
std::filesystem::path real_path(const std::filesystem::path& path);

/// True where a path is that of a folder or of something in it, whatever links lead there.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace keiko
