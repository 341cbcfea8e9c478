#pragma once

#include <filesystem>

namespace keiko {

/// Absolute path of the program or shared library that holds Keiko's code, without symbolic links.
/// It is that of the library where a program of another kind, an interpreter say, has loaded it.
std::filesystem::path binary_path();

} // namespace keiko
