#include "keiko/report/markup/html_table.h"

#include "keiko/report/markup/html_text.h"

namespace keiko {

std::string html_table_head(const std::vector<std::string>& names, std::string_view left) {
    std::string html = "<div class=\"card scroll\"><table><thead><tr>";
    for (const std::string& name : names)
        html += "<th" + std::string(name == left ? " class=\"left\"" : "") +
                "><button type=\"button\">" + name + "</button></th>";
    return html + "</tr></thead><tbody>\n";
}

std::string html_cell(const std::string& sort_key, const std::string& text,
                      std::string_view classes) {
    const std::string named = classes.empty() ? "" : " class=\"" + std::string(classes) + "\"";
    return "<td" + named + " data-v=\"" + sort_key + "\">" + text + "</td>";
}

std::string html_number_cell(double value, const std::string& text, bool over) {
    return html_cell(short_number(value, 9), text, over ? "tone" : "");
}

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
