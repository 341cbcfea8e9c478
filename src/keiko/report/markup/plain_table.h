#pragma once

#include <string>
#include <vector>

namespace keiko {

/// A table in a card that scrolls. A heading that starts with '<' stands at the left; headings are
/// text, `rows` is HTML.
std::string html_plain_table(const std::vector<std::string>& headings, const std::string& rows);

/// A cell of escaped text.
std::string html_text_cell(const std::string& text, bool left = false);

} // namespace keiko
