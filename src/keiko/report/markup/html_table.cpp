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

} // namespace keiko
