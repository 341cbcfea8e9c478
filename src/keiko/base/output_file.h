#pragma once

#include <filesystem>
#include <string_view>

namespace keiko {

/// Writes `text` as the whole content of `target`, atomically: a reader never sees half a file,
/// after a power failure neither. A link stays one to the file that is written; pipes and character
/// devices are written directly. Throws Error, and then nothing is left behind.
void write_text_file(const std::filesystem::path& target, std::string_view text);

/// Waits until the names in a folder (empty: the working one) are on the disk. File systems that
/// cannot do it are believed.
void sync_to_disk(const std::filesystem::path& folder);

} // namespace keiko
