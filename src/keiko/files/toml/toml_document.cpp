#include "keiko/files/toml/toml_document.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace keiko {
namespace fs = std::filesystem;

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

void require_parsable_toml(std::string_view text, const std::string& source) {
    TomlWalk(text, source).walk();
}

TomlPlace place_of(const toml::source_region& region) {
    return {region.begin.line, region.begin.column};
}

TomlDateTime date_time_of(const toml::date_time& value) {
    const toml::time& time = value.time;
    TomlDateTime read{
        value.date.year, value.date.month, value.date.day,
        time.hour + time.minute / 60.0 + (time.second + time.nanosecond * 1e-9) / 3600};
    if (value.offset) read.offset = value.offset->minutes / 60.0;
    return read;
}

TomlValue value_of(const toml::node& node) {
    TomlValue value;
    value.place = place_of(node.source());
    if (const auto* real = node.as_floating_point()) value.content = real->get();
    if (const auto* whole = node.as_integer()) value.content = whole->get();
    if (const auto* text = node.as_string()) value.content = text->get();
    if (const auto* flag = node.as_boolean()) value.content = flag->get();
    if (const auto* time = node.as_date_time()) value.content = date_time_of(time->get());
    if (const auto* array = node.as_array()) {
        std::vector<TomlValue> values;
        for (const toml::node& element : *array) values.push_back(value_of(element));
        value.content = std::move(values);
    }
    if (const auto* table = node.as_table()) {
        std::vector<TomlEntry> entries;
        for (const auto& [key, element] : *table)
            entries.push_back({std::string(key.str()), place_of(key.source()), value_of(element)});
        value.content = std::move(entries);
    }
    return value;
}

} // namespace

TomlDocument parse_toml(std::string_view text, const std::string& source) {
    require_parsable_toml(text, source);
    try {
        const toml::table root = toml::parse(text, source);
        return {source, value_of(root)};
    } catch (const toml::parse_error& error) {
        throw Error(source, place_of(error.source()).text(), shortened(error.description()));
    }
}

namespace {

void collect_texts(const toml::node& node, std::vector<std::string>& texts) {
    if (const auto* text = node.as_string()) texts.push_back(text->get());
    if (const auto* array = node.as_array())
        for (const toml::node& element : *array) collect_texts(element, texts);
    if (const auto* table = node.as_table())
        for (const auto& [key, element] : *table) collect_texts(element, texts);
}

std::vector<std::string> texts_of(const fs::path& file) {
    const std::string content = read_text_file(file);
    require_parsable_toml(content, file.string());
    std::vector<std::string> texts;
    try {
        collect_texts(toml::parse(content, file.string()), texts);
    } catch (const toml::parse_error& error) {
        throw Error(file.string(), std::to_string(error.source().begin.line),
                    shortened(error.description()));
    }
    return texts;
}

void follow(const fs::path& file, std::set<fs::path>& found) {
    if (!found.insert(file).second || file.extension() != ".toml") return;
    for (const std::string& text : texts_of(file)) {
        if (text.find('\0') != std::string::npos) continue; // the name of no file
        const fs::path named = (file.parent_path() / text).lexically_normal();
        std::error_code no_file;
        if (fs::is_regular_file(named, no_file)) follow(named, found);
    }
}

} // namespace

std::vector<fs::path> files_named_by(const fs::path& toml_file) {
    std::set<fs::path> found;
    follow(toml_file.lexically_normal(), found);
    return {found.begin(), found.end()};
}

} // namespace keiko
