#pragma once

#include <filesystem>
#include <functional>

namespace keiko {

/// A file that is written beside its place, with the same extension, and is gone again unless it is
/// put there. A link stays one to the file that is written; into a device or a pipe the bytes are
/// copied.
class PendingFile {
public:
    /// Throws Error where the path is that of a directory.
    explicit PendingFile(const std::filesystem::path& path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Runs `write` on the temporary path and waits until the disk has it. Throws Error when it
    /// cannot be written, and what `write` throws.
    void fill(const std::function<void(const std::filesystem::path& temporary)>& write);
    /// Throws Error.
    void put_in_place();

private:
    std::filesystem::path path_, target_, temporary_;
    bool stream_ = false; ///< a device or a pipe: nothing may take its place
};

} // namespace keiko
