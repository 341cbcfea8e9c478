#pragma once

#include <filesystem>

namespace keiko::cli {

/// Throws Error where no file can be written at `path`: told before the long work that makes it.
void require_place_for_file(const std::filesystem::path& path);

/// The same for files in a folder, which may be missing itself, its parents too.
void require_place_for_folder(const std::filesystem::path& folder);

} // namespace keiko::cli
