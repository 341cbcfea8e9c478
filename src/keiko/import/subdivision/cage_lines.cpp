#include "keiko/import/subdivision/cage_lines.h"

#include "keiko/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace keiko::subdivision {
namespace {

std::string_view without_plus(std::string_view word) {
    return word.starts_with('+') ? word.substr(1) : word;
}

template <class Number>
bool read_whole_word(std::string_view word, Number& value) {
    const std::string_view digits = without_plus(word);
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return code == std::errc() && end == digits.data() + digits.size();
}

} // namespace

bool CageLines::next(Statement& statement) {
    statement.words.clear();
    bool continued = false;
    while (position_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', position_), text_.size());
        std::string_view line = std::string_view(text_).substr(position_, end - position_);
        position_ = end + 1;
        ++line_;
        if (statement.words.empty()) statement.line = line_;
        line = line.substr(0, line.find('#'));
        const std::size_t last = line.find_last_not_of(" \t\r");
        continued = last != std::string_view::npos && line[last] == '\\';
        append_words(continued ? line.substr(0, last) : line, statement);
        if (!continued && !statement.words.empty()) return true;
    }
    return !statement.words.empty();
}

void CageLines::append_words(std::string_view line, Statement& statement) const {
    constexpr std::string_view blanks = " \t\r\f\v";
    while (true) {
        const std::size_t begin = line.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return;
        line.remove_prefix(begin);
        const std::size_t size = std::min(line.find_first_of(blanks), line.size());
        statement.words.push_back(line.substr(0, size));
        line.remove_prefix(size);
    }
}

double CageLines::number(const Statement& statement, std::string_view word) const {
    double value = 0;
    if (!read_whole_word(word, value) || !std::isfinite(value))
        fail(statement.line, "not a finite number: " + in_quotes(word));
    return value;
}

long CageLines::whole(const Statement& statement, std::string_view word) const {
    long value = 0;
    if (!read_whole_word(word, value))
        fail(statement.line, "not a whole number: " + in_quotes(word));
    return value;
}

} // namespace keiko::subdivision
