#pragma once

#include <filesystem>

namespace keiko {

/// What a path leads to where it is a link, also one to what is not there yet; else the path.
std::filesystem::path behind_links(const std::filesystem::path& path);

/// A path without links, absolute, also of what is not there yet.
std::filesystem::path real_path(const std::filesystem::path& path);

/// Whether a path is that of a folder or of something in it, whatever links lead there.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace keiko
