#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace keiko {

/// Reads a text line by line, without the characters that end a line.
class LineReader {
public:
    /// Reader of a text that must outlive it.
    explicit LineReader(std::string_view text) : text_(text) {}

    /// The next line; nullopt after the last.
    std::optional<std::string_view> next();
    /// Number of the last line, from 1.
    std::size_t number() const { return number_; }
    /// Text that follows the last line.
    std::string_view rest() const { return text_; }

private:
    std::string_view text_;
    std::size_t number_ = 0;
};

/// Takes the next word off the front of a line; empty where there is none left. Words stand between
/// the characters of `blanks`.
std::string_view take_word(std::string_view& line, std::string_view blanks = " \t");

/// The number that a word is, as a whole; nullopt for any other word.
std::optional<double> number_in(std::string_view word);

} // namespace keiko
