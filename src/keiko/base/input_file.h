#pragma once

#include <filesystem>
#include <string>

namespace keiko {

/// The whole content of a file. Throws Error naming the path when it is missing, a directory, a
/// device, unreadable or empty.
std::string read_file(const std::filesystem::path& path);

/// Throws the same errors as read_file, without reading.
void require_readable_file(const std::filesystem::path& path);

} // namespace keiko
