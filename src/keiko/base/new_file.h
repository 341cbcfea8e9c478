#pragma once

#include "keiko/base/descriptor.h"

#include <fcntl.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace keiko {

/// Permissions of a file that anybody may read whom the umask lets.
constexpr mode_t public_file = 0666;
/// Permissions of a file of the user alone.
constexpr mode_t private_file = 0600;

/// Error of a system call that failed on `path`: "WHAT: " and the system's reason, from errno.
[[noreturn]] void throw_system_error(const std::filesystem::path& path, const std::string& what);

/// New, empty file, open for writing. Whatever has the name already, a link too, is an error: it is
/// neither followed nor written. `path` starts at the open directory `folder`; the umask is taken
/// off `mode`. Throws Error.
Descriptor create_file(const std::filesystem::path& path, mode_t mode = public_file,
                       int folder = AT_FDCWD);

/// Writes all bytes to an open file. `path` is for the error alone. Throws Error.
void write_all(const Descriptor& file, std::string_view bytes, const std::filesystem::path& path);

/// Name for a file or folder that is not finished: ".keiko-PID-RANDOM.tmp". Nobody can foresee it.
std::string temporary_name();

/// Whether the name is one of temporary_name() in a process that is gone.
bool is_abandoned(const std::string& name);

} // namespace keiko
