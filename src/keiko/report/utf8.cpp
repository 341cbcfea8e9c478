#include "keiko/report/utf8.h"

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
