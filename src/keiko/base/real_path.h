#pragma once

#include <filesystem>

namespace keiko {

/// A path without links, absolute, also of what is not there yet.
std::filesystem::path real_path(const std::filesystem::path& path);

/// Whether a path is that of a folder or of something in it, whatever links lead there.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace keiko
