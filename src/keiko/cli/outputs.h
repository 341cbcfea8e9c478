#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace keiko::cli {

// Where results go: places for files, judged before the long work, and standard output.

/// Throws Error if no file can be written at `path`: reported before the long work that makes it.
void require_place_for_file(const std::filesystem::path& path);

/// Throws Error if no file can be written in a folder, which may be missing itself, its parents
/// too.
void require_place_for_folder(const std::filesystem::path& folder);

/// Throws Error if two outputs are the same file, or one is an input. Devices and pipes may be
/// named more than once. Empty paths are ignored.
void require_distinct(std::span<const std::filesystem::path> outputs,
                      std::span<const std::filesystem::path> inputs);

/// Writes lines of results to standard output, for every command except those that write while they
/// read. Names of files and faces cannot control the terminal: control characters except line
/// breaks become '?'.
void print(std::string_view lines);

} // namespace keiko::cli
