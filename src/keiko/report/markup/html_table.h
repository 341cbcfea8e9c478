#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keiko {

// Tables of a page. A reader sorts some by pressing a heading: each cell has the key by which it is
// sorted. Plain ones stay in their order.

/// The opening of a sortable table with its headings; those of `left` hold text.
std::string html_table_head(const std::vector<std::string>& names, std::string_view left);
/// The end of such a table.
constexpr std::string_view html_table_end = "</tbody></table></div>";

/// A cell of a sortable table. Nothing is escaped: `text` is HTML, `sort_key` has no quotes.
std::string html_cell(const std::string& sort_key, const std::string& text,
                      std::string_view classes = "");
/// A cell of a number; `over`: shown in the colour of its row.
std::string html_number_cell(double value, const std::string& text, bool over);

/// A plain table in a card that scrolls. A heading that starts with '<' stands at the left;
/// headings are text, `rows` is HTML.
std::string html_plain_table(const std::vector<std::string>& headings, const std::string& rows);

/// A cell of escaped text in a plain table.
std::string html_text_cell(const std::string& text, bool left = false);

} // namespace keiko
