#pragma once

#include "keiko/base/new_file.h"
#include "keiko/base/output_target.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace keiko {

/// Output that is written beside its place, and is gone again unless it is put there. A link stays
/// one to the file that is written; into a pipe or a device the bytes are written in the end.
class AtomicFile {
public:
    /// Throws Error where output_target() refuses the path and where its folder takes no file.
    explicit AtomicFile(const std::filesystem::path& path);

    /// Writes the whole content and waits until the disk has it. Throws Error.
    void fill(std::string_view bytes);
    /// Throws Error.
    void put_in_place();

private:
    OutputTarget target_;
    std::optional<TemporaryFile> file_; ///< of a target that is no stream
    std::string bytes_;                 ///< for a stream, which nothing may take the place of
};

/// Writes `text` as the whole content of `target`, atomically: a reader never sees half a file,
/// after a power failure neither. A link stays one to the file that is written; pipes and character
/// devices are written directly. Throws Error, and then nothing is left behind.
void write_text_file(const std::filesystem::path& target, std::string_view text);

/// Waits until the names in a folder (empty: the working one) are on the disk. File systems that
/// cannot do it are believed.
void sync_to_disk(const std::filesystem::path& folder);

} // namespace keiko
