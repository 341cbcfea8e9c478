#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keiko {

// Tables that a reader sorts by pressing a heading: each cell has the key by which it is sorted.

/// The opening of a table with its headings; those of `left` hold text.
std::string html_table_head(const std::vector<std::string>& names, std::string_view left);
/// The end of such a table.
constexpr std::string_view html_table_end = "</tbody></table></div>";

std::string html_cell(const std::string& sort_key, const std::string& text,
                      std::string_view classes = "");
/// A cell of a number; `over`: shown in the colour of its row.
std::string html_number_cell(double value, const std::string& text, bool over);

} // namespace keiko
