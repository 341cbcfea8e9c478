#pragma once

#include <string>

namespace keiko {

/// Build id of the program or shared library that holds Keiko's code, in hexadecimal digits. It is
/// the linker's hash of the contents (--build-id), wherever the file lies and whatever program has
/// loaded it. Throws Error where the file was linked without one.
std::string build_id();

} // namespace keiko
