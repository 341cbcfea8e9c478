#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// A whole HTML page in the report's style. `title` and `more_style` are inserted unchanged, `body`
/// is the content of its main part, and `script` follows it, if any.
std::string html_page(std::string_view title, std::string_view more_style, std::string_view body,
                      std::string_view script = {});

/// Sorts a table by the column whose heading was pressed, by the cells' data-v; pressing again
/// reverses the order. A row that has a close-up shows it when it is pressed, and so does the
/// close-up itself.
extern const std::string_view report_script;

} // namespace keiko
