#pragma once

#include "keiko/base/new_file.h"

#include <filesystem>
#include <string_view>

namespace keiko {

/// New file beside the place that it is meant for; gone again unless it is put there. Its name
/// cannot be foreseen, and nothing that stands there is followed or written.
class TemporaryFile {
public:
    /// `target` starts at the open directory `folder`, which must outlive this; the umask is taken
    /// off `mode`. Throws Error naming `target`.
    explicit TemporaryFile(std::filesystem::path target, mode_t mode = public_file,
                           int folder = AT_FDCWD);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Appends bytes. Throws Error naming the target.
    void write(std::string_view bytes);
    /// Waits until the disk has all bytes, and takes no more. Throws Error naming the target.
    void finish();
    /// Renames the finished file to the target: a link there is replaced, never followed. Throws
    /// Error naming the target.
    void put_in_place();

private:
    std::filesystem::path target_, path_;
    int folder_;
    Descriptor file_;
};

} // namespace keiko
