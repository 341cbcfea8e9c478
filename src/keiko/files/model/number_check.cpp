#include "keiko/base/error.h"
#include "keiko/files/model/cad_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace keiko {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether a character belongs to a number or to a word for none.
bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.' ||
           c == '_';
}

std::string_view word_at(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && in_word(text[end])) ++end;
    return text.substr(at, end - at);
}

/// Whether a number without a sign is beyond all doubles. Few need to be read: three digits of
/// exponent or very many digits.
bool overflows(std::string_view number) {
    constexpr std::size_t many = 300;
    const std::size_t exponent = std::min(number.find_first_of("eEdD"), number.size());
    const std::size_t first = std::min(number.find_first_not_of("+0", exponent + 1), number.size());
    if (number.size() <= many && number.size() - first < 3) return false;
    std::string text(number);
    if (exponent < text.size()) text[exponent] = 'e';
    return std::isinf(std::strtod(text.c_str(), nullptr));
}

bool is_word_for_none(std::string_view word) {
    constexpr std::array<std::string_view, 3> words{"nan", "inf", "infinity"};
    return std::any_of(words.begin(), words.end(), [&](std::string_view none) {
        return std::equal(word.begin(), word.end(), none.begin(), none.end(), [](char a, char b) {
            return std::tolower(static_cast<unsigned char>(a)) == b;
        });
    });
}

bool is_not_finite(std::string_view word) {
    if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
    const bool number = word.size() > 1 && is_digit(word[word.front() == '.' ? 1 : 0]);
    return number ? overflows(word) : is_word_for_none(word);
}

std::size_t take_digits(std::string_view& text) {
    const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(count);
    return count;
}

void take_sign(std::string_view& text) {
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
}

bool begins_as_number(std::string_view word) {
    take_sign(word);
    if (word.starts_with('.')) word.remove_prefix(1);
    return word.empty() || word.front() == '+' || word.front() == '-' || is_digit(word.front());
}

/// How a format writes numbers.
struct NumberStyle {
    std::string_view exponents; ///< letters that may begin one
    bool point_before_exponent; ///< which a number with an exponent must have
    const char* reason;         ///< why another is refused
};
constexpr NumberStyle step_style{
    "E", true, " is no number of STEP (ISO 10303-21: digits, a point, E before an exponent)"};
constexpr NumberStyle iges_style{"EeDd", false, " is no number of IGES"};

bool is_number(std::string_view word, const NumberStyle& style) {
    take_sign(word);
    std::size_t digits = take_digits(word);
    const bool point = word.starts_with('.');
    if (point) word.remove_prefix(1), digits += take_digits(word);
    if (digits == 0) return false;
    if (word.empty()) return true;
    if (style.exponents.find(word.front()) == std::string_view::npos) return false;
    if (style.point_before_exponent && !point) return false;
    word.remove_prefix(1);
    take_sign(word);
    return take_digits(word) > 0 && word.empty();
}

/// Why OpenCASCADE must not see a word, or nothing.
const char* fault_of(std::string_view word, const NumberStyle& style) {
    if (word.empty()) return nullptr;
    if (is_not_finite(word)) return " is no finite number";
    return begins_as_number(word) && !is_number(word, style) ? style.reason : nullptr;
}

[[noreturn]] void refuse(std::string_view word, const char* reason, const std::string& source,
                         std::size_t line, const std::string& entity) {
    throw Error(source, std::to_string(line),
                (entity.empty() ? "" : "entity " + entity + ": ") + shortened(word) + reason);
}

/// Walk through the numbers of a STEP file [ISO10303-21]: entities "#12 = NAME(...);", texts in ',
/// binaries in ", comments as in C.
class StepWalk {
public:
    StepWalk(std::string_view text, const std::string& source) : text_(text), source_(source) {}

    void walk() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\'' || c == '"')
                at_ = past(text_.find(c, at_ + 1), 1);
            else if (c == '<') // an address, of edition 3
                at_ = past(text_.find('>', at_ + 1), 1);
            else if (c == '/' && text_.substr(at_, 2) == "/*")
                at_ = past(text_.find("*/", at_ + 2), 2);
            else if (c == '#')
                take_label();
            else if (in_word(c))
                take_word();
            else
                ++at_;
        }
    }

private:
    std::size_t past(std::size_t end, std::size_t size) const {
        return end == std::string_view::npos ? text_.size() : end + size;
    }

    /// "#12" before "=" names the entity that begins there.
    void take_label() {
        const std::size_t end =
            std::min(text_.find_first_not_of("0123456789", at_ + 1), text_.size());
        const std::size_t next = text_.find_first_not_of(" \t\r\n", end);
        if (next != std::string_view::npos && text_[next] == '=')
            entity_ = text_.substr(at_, end - at_);
        at_ = end;
    }

    void take_word() {
        std::string_view word = word_at(text_, at_);
        const std::string_view mark = text_.substr(at_ + word.size(), 2);
        // As Microsoft's libraries print what is no number: 1.#INF, -1.#QNAN.
        const bool marked = word.ends_with("1.") && mark.size() == 2 && mark[0] == '#' &&
                            std::isalpha(static_cast<unsigned char>(mark[1])) != 0;
        if (marked)
            word =
                text_.substr(at_, word.size() + 1 + word_at(text_, at_ + word.size() + 1).size());
        const char* fault = marked ? " is no finite number" : fault_of(word, step_style);
        if (fault != nullptr) {
            const auto lines = std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n');
            refuse(word, fault, source_, static_cast<std::size_t>(lines) + 1, std::string(entity_));
        }
        at_ += word.size();
    }

    std::string_view text_;
    const std::string& source_;
    std::size_t at_ = 0;
    std::string_view entity_; ///< "#12"
};

/// Walk through the numbers of an IGES file [IGES5.3, section 2.2.4]: lines of 80 columns. Those of
/// parameters hold P in column 73 and before it the directory entry of their entity; texts,
/// "5Hhello", run on over lines.
class IgesWalk {
public:
    explicit IgesWalk(const std::string& source) : source_(source) {}

    void take_line(std::string_view line) {
        ++line_;
        constexpr std::size_t section = 72, entry = 64;
        if (line.size() <= section || line[section] != 'P') return;
        std::string_view data = line.substr(0, entry);
        skip_text(data);
        while (!data.empty()) {
            if (begins_text(data)) {
                skip_text(data);
                continue;
            }
            const std::string_view word = word_at(data, 0);
            if (const char* fault = fault_of(word, iges_style); fault != nullptr)
                refuse(word, fault, source_, line_, label(line.substr(entry, 8)));
            data.remove_prefix(std::max<std::size_t>(word.size(), 1));
        }
    }

private:
    /// Takes "5H" off the front.
    bool begins_text(std::string_view& data) {
        const std::size_t digits = std::min(data.find_first_not_of("0123456789"), data.size());
        if (digits == 0 || digits == data.size() || data[digits] != 'H') return false;
        if (std::from_chars(data.data(), data.data() + digits, left_of_text_).ec != std::errc())
            return false;
        data.remove_prefix(digits + 1);
        return true;
    }

    void skip_text(std::string_view& data) {
        const std::size_t here = std::min(left_of_text_, data.size());
        data.remove_prefix(here);
        left_of_text_ -= here;
    }

    static std::string label(std::string_view entry) {
        const std::size_t begin = entry.find_first_not_of(' ');
        return begin == std::string_view::npos ? "" : "D" + std::string(entry.substr(begin));
    }

    const std::string& source_;
    std::size_t line_ = 0, left_of_text_ = 0;
};

void check_brep_line(std::string_view line, const std::string& source, std::size_t number) {
    for (std::size_t at = 0; at < line.size();) {
        const std::string_view word = word_at(line, at);
        if (is_not_finite(word)) refuse(word, " is no finite number", source, number, "");
        at += std::max<std::size_t>(word.size(), 1);
    }
}

template <class Take>
void for_each_line(std::string_view text, Take take) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        take(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

} // namespace

void require_numbers(std::string_view text, ModelFormat format, const std::string& source) {
    if (format == ModelFormat::step) StepWalk(text, source).walk();
    if (format == ModelFormat::iges)
        for_each_line(text, [walk = IgesWalk(source)](std::string_view line) mutable {
            walk.take_line(line);
        });
    if (format == ModelFormat::brep)
        for_each_line(text, [&, number = std::size_t{0}](std::string_view line) mutable {
            check_brep_line(line, source, ++number);
        });
}

} // namespace keiko
