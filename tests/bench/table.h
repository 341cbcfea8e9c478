#pragma once

#include <string>
#include <vector>

namespace keiko::bench {

/// Cells of text; the first `left` columns stand at the left, numbers at the right.
struct Table {
    std::vector<std::string> head{};
    std::vector<std::vector<std::string>> rows{};
    std::size_t left = 1;
};

/// For a terminal: columns aligned.
std::string text_of(const Table& table);
std::string markdown_of(const Table& table);

/// Three significant digits, thousands as they are; "–" for what is no number.
std::string digits(double value);
/// "0", "0.012 %", "3.4 %" of a count.
std::string share(std::size_t part, std::size_t whole);

} // namespace keiko::bench
