#pragma once

#include <string_view>

namespace keiko::cli {

/// Writes lines of results to standard output, for every command except those that write while they
/// read. Names of files and faces cannot control the terminal: control characters except line
/// breaks become '?'.
void print(std::string_view lines);

} // namespace keiko::cli
