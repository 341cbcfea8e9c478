#include "keiko/base/error_text.h"

#include "keiko/base/utf8.h"

#include <algorithm>

namespace keiko {

std::string one_line(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const bool shown = length > 0 && !controls_terminal(code_point(text.substr(0, length)));
        line += shown ? text.substr(0, length) : std::string_view("?");
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return line;
}

std::string shortened(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return one_line(text);
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
    std::size_t end = longest;
    while (end > 0 && continues(text[end])) --end;
    return one_line(text.substr(0, end)) + "...";
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    return '"' + shortened(word, longest) + '"';
}

} // namespace keiko
