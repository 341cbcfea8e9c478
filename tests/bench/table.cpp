#include "tests/bench/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace keiko::bench {
namespace {

/// Columns of UTF-8 text, every letter one wide.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& cell, std::size_t width, bool left) {
    const std::string blanks(width - width_of(cell), ' ');
    return left ? cell + blanks : blanks + cell;
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                 std::size_t left) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i)
        text += "  " + padded(cells[i], widths[i], i < left);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
}

std::string markdown_line(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
}

} // namespace

std::string text_of(const Table& table) {
    std::vector<std::size_t> widths;
    for (const std::string& cell : table.head) widths.push_back(width_of(cell));
    for (const auto& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], width_of(row[i]));
    std::string text = line(table.head, widths, table.left);
    for (const auto& row : table.rows) text += line(row, widths, table.left);
    return text;
}

std::string markdown_of(const Table& table) {
    std::string text = markdown_line(table.head) + "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) text += i < table.left ? "---|" : "--:|";
    text += "\n";
    for (const auto& row : table.rows) text += markdown_line(row);
    return text;
}

std::string digits(double value) {
    if (!std::isfinite(value)) return "–";
    char text[48];
    if (value != 0 && std::abs(value) < 1e-3)
        std::snprintf(text, sizeof text, "%.1e", value);
    else if (std::abs(value) >= 100)
        std::snprintf(text, sizeof text, "%.0f", value);
    else
        std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string share(std::size_t part, std::size_t whole) {
    if (part == 0) return "0";
    char text[48];
    std::snprintf(text, sizeof text, "%.2g %%",
                  100 * static_cast<double>(part) / static_cast<double>(whole));
    return text;
}

} // namespace keiko::bench
