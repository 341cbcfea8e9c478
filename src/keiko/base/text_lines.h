#pragma once

#include <sstream>
#include <string>
#include <string_view>

namespace keiko {

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

} // namespace keiko
