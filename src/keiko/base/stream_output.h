#pragma once

#include <filesystem>
#include <string_view>

namespace keiko {

/// Writes bytes into a pipe or a character device as it stands. Waits until someone reads the pipe,
/// and as long as it is full; a stop of the work (StopScope) ends the wait. Throws Error where the
/// path is neither of them by now and when the reader goes away, and Cancelled.
void write_to_stream(const std::filesystem::path& path, std::string_view bytes);

} // namespace keiko
