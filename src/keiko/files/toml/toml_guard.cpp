#include "keiko/files/toml/toml_guard.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <cstdint>

namespace keiko {
namespace {

/// toml++ limits the depth of values, but not that of keys a.b.c.
constexpr int most_parts = 100;

bool beyond_ascii(char c) {
    return static_cast<unsigned char>(c) >= 0x80;
}

bool is_any_of(std::string_view characters, char c) {
    return characters.find(c) != std::string_view::npos;
}

/// Walks over a text, from strings and comments to the characters between them.
class TomlWalk {
public:
    TomlWalk(std::string_view text, const std::string& source) : text_(text), source_(source) {
        constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
        if (text.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    }

    void walk() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'')
                take_string(c);
            else if (c == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else
                take(c);
        }
    }

private:
    void take(char c) {
        if (beyond_ascii(c)) fail("a character beyond ASCII that is not in quotes");
        if (c == '.' && ++parts_ > most_parts)
            fail("a key of more than " + std::to_string(most_parts) + " parts");
        if (is_any_of("\n=,[]{}", c)) parts_ = 1;
        if (in_value_ && (c == '=' || (is_any_of("[{", c) && !value_begins())))
            fail(std::string("'") + c + "' where nothing can begin");
        follow(c);
        if (!is_any_of(" \t", c)) previous_ = c;
        ++at_;
    }

    /// Keeps account of whether a key or a value may come next.
    void follow(char c) {
        if (c == '{' || (c == '[' && in_value_)) open_.push_back(c);
        if (is_any_of("]}", c) && !open_.empty()) open_.pop_back();
        const bool in_array = !open_.empty() && open_.back() == '[';
        if (c == '=' || is_any_of("]}", c))
            in_value_ = true;
        else if (is_any_of("{,\n", c))
            in_value_ = in_array;
    }

    bool value_begins() const { return is_any_of("=[,\n", previous_); }
    bool key_begins() const { return is_any_of("\n[{,.", previous_); }

    /// Elsewhere toml++ takes a quote for a part of a number, and what follows too.
    void take_string(char quote) {
        if (!(in_value_ ? value_begins() : key_begins()))
            fail("a quotation mark where no string can begin");
        skip_string();
        previous_ = quote;
    }

    /// Past the closing quote; a string of one line that is not closed ends with the line.
    void skip_string() {
        const char quote = text_[at_];
        const std::string three(3, quote);
        const bool many_lines = text_.substr(at_, 3) == three;
        for (at_ += many_lines ? 3 : 1; at_ < text_.size();) {
            const char c = text_[at_];
            if (quote == '"' && c == '\\') {
                skip_escape(many_lines);
            } else if (many_lines && text_.substr(at_, 3) == three) {
                // Up to two quotes more belong to the string.
                const std::size_t end = std::min(text_.find_first_not_of(quote, at_), text_.size());
                at_ = std::min(at_ + 5, end);
                return;
            } else {
                ++at_;
                if (!many_lines && (c == quote || c == '\n')) return;
            }
        }
    }

    void skip_escape(bool many_lines) {
        const std::size_t next =
            std::min(text_.find_first_not_of(" \t\r\n", at_ + 1), text_.size());
        const bool joins_lines = many_lines && next > at_ + 1;
        const std::size_t end = joins_lines ? next : at_ + 1;
        if (end < text_.size() && beyond_ascii(text_[end]))
            fail("a character beyond ASCII follows a backslash");
        at_ = joins_lines ? next : std::min(at_ + 2, text_.size());
    }

    [[noreturn]] void fail(const std::string& reason) const {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
        throw Error(source_, std::to_string(line), reason);
    }

    std::string_view text_;
    const std::string& source_;
    std::size_t at_ = 0;
    int parts_ = 1;
    std::string open_;      ///< brackets of arrays and braces of inline tables
    bool in_value_ = false; ///< rather than in a key
    char previous_ = '\n';  ///< the last character that is no blank
};

} // namespace

void require_parsable_toml(std::string_view text, const std::string& source) {
    TomlWalk(text, source).walk();
}

} // namespace keiko
