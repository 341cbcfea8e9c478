#include "keiko/files/model/cad_text.h"

#include <algorithm>
#include <charconv>

namespace keiko {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Goes through the statements of a STEP file. Each ends in a semicolon.
class StepStatements {
public:
    explicit StepStatements(std::string_view text) : text_(text) {}

    std::unordered_map<std::uint64_t, std::uint32_t> entity_lines() {
        std::unordered_map<std::uint64_t, std::uint32_t> lines;
        for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
            if (const auto number = entity_number()) lines.emplace(number, line());
            skip_statement();
        }
        return lines;
    }

private:
    std::size_t past(std::string_view mark, std::size_t from) const {
        const std::size_t found = text_.find(mark, from);
        return found == std::string_view::npos ? text_.size() : found + mark.size();
    }

    bool at_comment() const { return text_.substr(at_, 2) == "/*"; }

    void skip_blanks() {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
            if (!at_comment()) return;
            at_ = past("*/", at_ + 2);
        }
    }

    void skip_statement() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == ';') return void(++at_);
            if (c == '\'' || c == '"')
                at_ = past(text_.substr(at_, 1), at_ + 1);
            else
                at_ = at_comment() ? past("*/", at_ + 2) : at_ + 1;
        }
    }

    /// N of "#N ="; 0 where another statement begins.
    std::uint64_t entity_number() const {
        if (text_[at_] != '#') return 0;
        std::uint64_t number = 0;
        const char* const end = text_.data() + text_.size();
        const auto [rest, code] = std::from_chars(text_.data() + at_ + 1, end, number);
        if (code != std::errc()) return 0;
        const std::size_t next =
            text_.find_first_not_of(blanks, static_cast<std::size_t>(rest - text_.data()));
        return next != std::string_view::npos && text_[next] == '=' ? number : 0;
    }

    /// Line of the place reached. Lines end in LF, CR LF or CR.
    std::uint32_t line() {
        for (; counted_ < at_; ++counted_) {
            const bool lone_return =
                text_[counted_] == '\r' && text_.substr(counted_ + 1, 1) != "\n";
            line_ += text_[counted_] == '\n' || lone_return ? 1 : 0;
        }
        return line_;
    }

    std::string_view text_;
    std::size_t at_ = 0, counted_ = 0;
    std::uint32_t line_ = 1;
};

} // namespace

std::unordered_map<std::uint64_t, std::uint32_t> step_entity_lines(std::string_view text) {
    return StepStatements(text).entity_lines();
}

} // namespace keiko
