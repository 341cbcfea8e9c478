#include "keiko/base/utf8.h"

#include <algorithm>

namespace keiko {
namespace {

/// The sequences that begin with a right lead byte and are wrong all the same.
bool forbidden(std::string_view sequence) {
    const std::string_view start = sequence.substr(0, 2);
    const bool overlong =
        (start[0] == '\xe0' && start[1] < '\xa0') || (start[0] == '\xf0' && start[1] < '\x90');
    const bool surrogate = start[0] == '\xed' && start[1] > '\x9f';
    const bool beyond_unicode = start[0] == '\xf4' && start[1] > '\x8f';
    const bool no_character = sequence == "\xef\xbf\xbe" || sequence == "\xef\xbf\xbf";
    return overlong || surrogate || beyond_unicode || no_character;
}

} // namespace

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    const std::size_t length = lead < 0x80    ? 1
                               : lead < 0xc2  ? 0
                               : lead < 0xe0  ? 2
                               : lead < 0xf0  ? 3
                               : lead <= 0xf4 ? 4
                                              : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    return length > 2 && forbidden(text.substr(0, length)) ? 0 : length;
}

char32_t code_point(std::string_view sequence) {
    const auto lead = static_cast<unsigned char>(sequence[0]);
    if (sequence.size() == 1) return lead;
    // The lead byte of a sequence of n bytes begins with n ones and a zero.
    char32_t character = lead & (0xffu >> (sequence.size() + 1));
    for (const char c : sequence.substr(1))
        character = character << 6 | (static_cast<unsigned char>(c) & 0x3fu);
    return character;
}

bool controls_terminal(char32_t c) {
    const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    return c < 0x20 || within(0x7f, 0x9f) || c == 0x61c || within(0x200e, 0x200f) ||
           within(0x2028, 0x202e) || within(0x2066, 0x2069);
}

std::string as_utf8(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        result += length == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

} // namespace keiko
