#pragma once

#include "keiko/base/export.h"

#include <cctype>
#include <cstddef>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// Length in bytes of the UTF-8 sequence at the front of a text that is not empty. 0 where there is
/// none ([RFC3629]: no overlong ones, no surrogates) or XML does not allow its character.
std::size_t utf8_length(std::string_view text);

/// The character of a UTF-8 sequence, as utf8_length has found it.
char32_t code_point(std::string_view sequence);

/// True if a terminal obeys a character instead of showing it: control characters, line and
/// paragraph separators, and the marks that change the direction of text.
bool controls_terminal(char32_t character);

/// The text with every byte that is no UTF-8 replaced by U+FFFD: names come from CAD files in any
/// encoding.
std::string as_utf8(std::string_view text);

/// Text from a file as a message may show it: control characters, which would break the line or
/// reach the terminal, become '?'.
std::string one_line(std::string_view text);

/// Text as one_line() shows it, at most `longest` bytes of it and "..." for the rest. UTF-8 is cut
/// between letters.
std::string shortened(std::string_view text, std::size_t longest = 300);

/// The beginning of a word of a file, in double quotes.
std::string in_quotes(std::string_view word);

/// Text output in lines. What is streamed into one of them stays on it and cannot control a
/// terminal, whatever names of files it holds: control characters become '?'.
class TextLines {
public:
    /// Ends the line before and begins one, to stream into.
    std::ostream& line();
    /// A line that begins with the name of what it holds, padded to a column.
    std::ostream& line(std::string_view name);

    /// All lines, each with a line break at its end.
    std::string text() const;

private:
    std::string ended_;
    std::ostringstream open_;
    bool is_open_ = false;
};

/// Text as a terminal may show it: lines stay, other control characters become '?'.
std::string terminal_text(std::string_view lines);

/// "1 seam", "2 seams", "0 seams": a number and the noun it is of, whose plural ends in s.
inline std::string counted(std::size_t number, std::string_view noun) {
    return std::to_string(number) + " " + std::string(noun) + (number == 1 ? "" : "s");
}

/// Letters of ASCII in lower case; other bytes as they are.
inline std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// " (did you mean 'pitch'?)" when one of the `candidates` is about what was typed, else "".
/// Of equally near ones the first.
std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates);

/// "a, b, c"; of very many words the beginning.
std::string comma_list(std::span<const std::string> words);

} // namespace keiko
