#pragma once

#include <string>

namespace keiko {

/// Build id of the program or shared library that Keiko's code is part of, as hexadecimal digits:
/// the linker's hash of its contents (--build-id), the same wherever the file lies and whatever
/// program has loaded it. Throws Error where it was linked without one.
std::string build_id();

} // namespace keiko
