#pragma once

#include "keiko/math/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace keiko {

// Text, numbers and bytes as a page has them.

/// Text escaped for an HTML element or a quoted attribute. Control characters, which HTML forbids,
/// become spaces, and bytes that are not UTF-8 become U+FFFD.
std::string html_escaped(std::string_view text);

/// A number with this many decimals, e.g. fixed_number(0.0125, 3) = "0.013" (or "0.012"). A size
/// below half the last decimal but not 0 becomes "< 0.001". A number that is not finite becomes a
/// dash.
std::string fixed_number(double value, int decimals);

/// A bar that is full at a share of 1, empty at 0 or without a number.
std::string html_bar(double share);

/// A number with this many significant digits, in the shorter of the usual notations.
std::string short_number(double value, int digits = 3);

/// "12.3, -45.6, 789.0", mm.
std::string place_text(const Vec3& place);

/// "x 12.0, y -3.5, z 820.1 mm"
std::string place_with_axes(const Vec3& place);

/// Base64 text of bytes [RFC4648], padded, in one line.
std::string base64(std::string_view bytes);

// Tables of a page. A reader sorts some by pressing a heading: each cell has the key by which it is
// sorted. Plain ones stay in their order.

/// The opening of a sortable table with its headings; those of `left` hold text.
std::string html_table_head(const std::vector<std::string>& names,
                            const std::vector<std::string>& left);
/// The end of such a table.
constexpr std::string_view html_table_end = "</tbody></table></div>";

/// A cell of a sortable table. Nothing is escaped: `text` is HTML, `sort_key` has no quotes.
std::string html_cell(const std::string& sort_key, const std::string& text,
                      std::string_view classes = "");
/// A cell of text, which is escaped and sorted by itself.
std::string html_words_cell(const std::string& text);
/// A cell of a place, world, mm, sorted by its x.
std::string html_place_cell(const Vec3& place);
/// A cell of a number; `over`: shown in the colour of its row.
std::string html_number_cell(double value, const std::string& text, bool over);

/// A plain table in a card that scrolls. A heading that starts with '<' stands at the left;
/// headings are text, `rows` is HTML.
std::string html_plain_table(const std::vector<std::string>& headings, const std::string& rows);

/// A cell of escaped text in a plain table.
std::string html_text_cell(const std::string& text, bool left = false);

} // namespace keiko
