#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_table.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

std::string row(const Report& report, const Check& look) {
    const std::string opens =
        look.face == no_index ? "" : html_opens_close_up(report, CloseUp::Of::face, look.face);
    const MeasuredValue& worst = look.worst;
    return "<tr class=\"undecided\"" + opens + ">" +
           html_cell(html_escaped(look.faces), html_escaped(look.faces), "left") +
           html_cell(look.code, look.code, "left") +
           html_number_cell(worst.value, short_number(worst.value, 3) + " " + look.unit, true) +
           html_cell(look.message, html_escaped(look.message), "left") +
           html_cell(short_number(worst.place.x, 9), place_text(worst.place)) + "</tr>\n";
}

} // namespace

std::string html_looks(const Report& report) {
    const std::vector<Check>& looks = report.inspection.looks;
    if (looks.empty()) return "";
    std::string html =
        "<section><h2>Worth a look</h2><p class=\"soft\">Reported, not judged: "
        "nothing here has a part in the verdict.</p>" +
        html_table_head({"face", "code", "value", "what", "place x, y, z"}, "face");
    for (const Check& look : looks) html += row(report, look);
    return html + std::string(html_table_end) + "</section>\n";
}

} // namespace keiko
