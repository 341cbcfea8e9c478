#pragma once

#include <filesystem>
#include <string>

namespace keiko {

// The program or shared library that holds Keiko's code: where it lies, and what it was built as.

/// Absolute path of the program or shared library that holds Keiko's code, without symbolic links.
/// It is that of the library where a program of another kind, an interpreter say, has loaded it.
std::filesystem::path binary_path();

/// Build id of the program or shared library that holds Keiko's code, in hexadecimal digits. It is
/// the linker's hash of the contents (--build-id), wherever the file lies and whatever program has
/// loaded it. Throws Error where the file was linked without one.
std::string build_id();

} // namespace keiko
