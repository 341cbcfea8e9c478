#include "keiko/report/markup/plain_table.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {

std::string html_plain_table(const std::vector<std::string>& headings, const std::string& rows) {
    std::string html = "<div class=\"card scroll\"><table><thead><tr>";
    for (const std::string& heading : headings) {
        const bool left = heading.starts_with("<");
        html += std::string("<th") + (left ? " class=\"left\"" : "") + ">" +
                html_escaped(left ? heading.substr(1) : heading) + "</th>";
    }
    return html + "</tr></thead><tbody>" + rows + "</tbody></table></div>\n";
}

std::string html_text_cell(const std::string& text, bool left) {
    return std::string(left ? "<td class=\"left\">" : "<td>") + html_escaped(text) + "</td>";
}

} // namespace keiko
