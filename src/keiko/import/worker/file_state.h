#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace keiko {

/// Identity of a file and its last change, from the file system.
struct FileStamp {
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t changed = 0; ///< ns since 1970, of content or status: no program can set it

    bool operator==(const FileStamp&) const = default;
};

/// Stamp of the file that a path leads to. Throws Error.
FileStamp file_stamp(const std::filesystem::path& file);

/// A file at one moment, to find out later whether it has changed.
struct FileState {
    FileStamp stamp;    ///< taken before the content was read
    std::string sha256; ///< of the content
};

/// State of a file as it is now. Throws Error when it cannot be read.
FileState file_state(const std::filesystem::path& file);

} // namespace keiko
