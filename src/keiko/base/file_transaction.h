#pragma once

#include "keiko/base/output_folder.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace keiko {

/// Files that are written together: all of them, or none.
class FileTransaction {
public:
    /// Adds a file with its content. Nothing is written, and its folder is not made.
    void add(std::filesystem::path path, std::string bytes);
    /// Files in a folder, which is made where it is missing, its parents too.
    void add_folder(const std::filesystem::path& folder, FolderContent&& content);

    /// Writes all of them beside their places, and puts them there once the last one is on the
    /// disk. Throws Error naming the one that cannot be written; then no file has changed and no
    /// folder was made, unless a file system has room for the bytes but not for a name.
    void write() const;

private:
    std::vector<std::filesystem::path> folders_;
    std::vector<std::pair<std::filesystem::path, std::string>> files_;
};

} // namespace keiko
