#pragma once

#include <filesystem>

namespace keiko {

/// Copies a file into a device or a pipe, which stays in its place. Waits until someone reads the
/// pipe, and as long as it is full; a stop of the work (StopScope) ends the wait. Throws Error
/// naming the stream where it cannot be written, Cancelled.
void copy_into_stream(const std::filesystem::path& file, const std::filesystem::path& stream);

} // namespace keiko
