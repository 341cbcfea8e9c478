#pragma once

#include <string_view>

namespace keiko::cli {

/// Writes lines of results to standard output, where every command but those that write as they
/// read has them from. Names of files and faces cannot control the terminal: control characters
/// but line breaks become '?'.
void print(std::string_view lines);

} // namespace keiko::cli
