#include "keiko/base/text.h"

#include <algorithm>
#include <cctype>
#include <vector>

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

namespace {

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal
/// string alignment); letters of either case are the same.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    const auto same = [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
    };
    std::vector<std::size_t> before, last, row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::move(last);
        last = std::move(row);
        row.assign(b.size() + 1, i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min(
                {last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0u : 1u)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row.back();
}

} // namespace

std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates) {
    std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
    const std::string* nearest = nullptr;
    for (const std::string& candidate : candidates)
        // Words that share no letter are not like each other, however short they are.
        if (const std::size_t d = edit_distance(typed, candidate);
            d < least && d < std::max(typed.size(), candidate.size()))
            least = d, nearest = &candidate;
    return nearest ? " (did you mean '" + shortened(*nearest) + "'?)" : "";
}

std::string comma_list(std::span<const std::string> words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    // Our own names are all listed; those of a file's materials may be many.
    constexpr std::size_t longest = 1000;
    return shortened(list, longest);
}

} // namespace keiko
