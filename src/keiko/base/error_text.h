#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace keiko {

/// Text from a file as a message may show it: control characters, which would break the line or
/// reach the terminal, become '?'.
std::string one_line(std::string_view text);

/// The same, at most `longest` bytes of it and "..." for the rest; UTF-8 is cut between letters.
std::string shortened(std::string_view text, std::size_t longest = 300);

/// The beginning of a word of a file, in double quotes.
std::string in_quotes(std::string_view word);

} // namespace keiko
