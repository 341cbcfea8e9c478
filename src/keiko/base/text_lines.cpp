#include "keiko/base/text_lines.h"

#include "keiko/base/error_text.h"

#include <algorithm>

namespace keiko {

std::ostream& TextLines::line() {
    ended_ = text();
    open_.str("");
    is_open_ = true;
    return open_;
}

std::ostream& TextLines::line(std::string_view name) {
    constexpr std::size_t width = 12;
    return line() << name << std::string(width - std::min(width, name.size()), ' ');
}

std::string TextLines::text() const {
    return is_open_ ? ended_ + one_line(open_.str()) + "\n" : ended_;
}

std::string terminal_text(std::string_view lines) {
    std::string text;
    for (std::size_t begin = 0; begin < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', begin), lines.size());
        text += one_line(lines.substr(begin, end - begin));
        if (end < lines.size()) text += '\n';
        begin = end + 1;
    }
    return text;
}

} // namespace keiko
