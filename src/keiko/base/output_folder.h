#pragma once

#include "keiko/base/export.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace KEIKO_API keiko {

/// The only writer of a folder for as long as it lives. What writers that were killed have left
/// behind there is gone when it is made.
class FolderLock {
public:
    /// Makes the folder where it is missing; waits for others to end, by default a moment for
    /// readers. Throws Error when another process holds it, and when it cannot be written.
    explicit FolderLock(const std::filesystem::path& folder,
                        std::chrono::milliseconds patience = std::chrono::seconds(1));
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_ = -1;
};

/// Keeps writers out of a folder while it lives; any number of readers may be there. A folder that
/// is not there is not locked.
class FolderReadLock {
public:
    /// Waits some seconds for a writer to end. Throws Error when it does not.
    explicit FolderReadLock(const std::filesystem::path& folder);
    ~FolderReadLock();
    FolderReadLock(const FolderReadLock&) = delete;
    FolderReadLock& operator=(const FolderReadLock&) = delete;

private:
    int descriptor_ = -1;
};

/// File names and their bytes.
using FolderContent = std::map<std::string, std::string>;

/// Makes a folder of these files, in place of the one that is there: at every moment either the
/// whole old folder or the whole new one is found. The caller holds the lock of the folder it lies
/// in. Throws Error.
void write_folder_atomically(const std::filesystem::path& target, const FolderContent& content);

/// Every file of a folder; nothing where there is no folder. Throws Error.
FolderContent read_folder(const std::filesystem::path& folder);

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
