#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// Length in bytes of the UTF-8 sequence at the front of a text that is not empty, or 0 where there
/// is none ([RFC3629]: no overlong ones, no surrogates) or XML does not allow its character.
std::size_t utf8_length(std::string_view text);

/// The character of a UTF-8 sequence, as utf8_length has found it.
char32_t code_point(std::string_view sequence);

/// Whether a terminal obeys a character instead of showing it: control characters, line and
/// paragraph separators, and the marks that change the direction of text.
bool controls_terminal(char32_t character);

/// The text with every byte that is no UTF-8 replaced by U+FFFD: names come from CAD files in any
/// encoding.
std::string as_utf8(std::string_view text);

} // namespace keiko
