#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace keiko {

/// Runs `write` on a temporary path beside `target` (same extension, so that image writers
/// recognise the format) and renames it to `target` when `write` returned: a reader never sees
/// half a file, after a power failure neither, and nothing remains when `write` throws. A link
/// stays one to the file that is written; into a device or a pipe the bytes are copied in the end.
/// Throws Error when the folder cannot be written.
void write_atomically(const std::filesystem::path& target,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// Waits until a file, or the names in a folder (empty: the working one), are on the disk. File
/// systems that cannot tell are believed.
void sync_to_disk(const std::filesystem::path& path);

/// Writes the whole content of a file, not atomically. Throws Error naming `name`.
void write_bytes(const std::filesystem::path& path, std::string_view bytes,
                 const std::filesystem::path& name);

/// Writes `text` as the whole content of `target`, atomically.
void write_text_file(const std::filesystem::path& target, std::string_view text);

} // namespace keiko
