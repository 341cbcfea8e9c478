#pragma once

#include <filesystem>

namespace keiko {

/// File behind the links of a path; it need not exist. Throws Error for a link that somebody else
/// may have planted: in a folder where everybody may write, and neither the user's own nor that of
/// the folder's owner.
std::filesystem::path behind_links(const std::filesystem::path& path);

/// True if a path is neither a file nor a folder: a pipe or a device, that keeps its place.
bool is_stream(const std::filesystem::path& path);

/// Place that an output goes to: a file, or a stream that is written directly.
struct OutputTarget {
    std::filesystem::path path; ///< a file's without links, a stream's as it was named
    bool stream = false;        ///< a named pipe or a character device
};

/// Place that an output of this path goes to. Throws Error for a directory, a block device, a
/// socket, and for a link or a pipe that somebody else may have planted.
OutputTarget output_target(const std::filesystem::path& path);

/// The absolute path without links, also of a file that does not exist.
std::filesystem::path real_path(const std::filesystem::path& path);

/// True where a path is that of a folder or of something in it, whatever links lead there.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace keiko
