#include "keiko/report/content/acceptance_texts.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

/// A row of a table of checks; `id`: its anchor, if any; `first` and `last`: cells of further
/// columns.
std::string row(const Report& report, const Check& check, const std::string& id,
                std::string_view tone, const std::string& first, const std::string& last) {
    std::string opens;
    if (check.face != no_index) opens = html_opens_close_up(report, CloseUp::Of::face, check.face);
    if (check.seam != no_index) opens = html_opens_close_up(report, CloseUp::Of::seam, check.seam);
    const MeasuredValue& worst = check.worst;
    const std::string anchor = id.empty() ? "" : " id=\"" + id + "\"";
    return "<tr" + anchor + " class=\"" + std::string(tone) + "\"" + opens + ">" + first +
           html_words_cell(check.view.empty() ? check.faces : subject_of(check)) +
           html_words_cell(check.code) + html_number_cell(worst.value, value_text(check), true) +
           html_words_cell(check.message) + html_place_cell(worst.place) + last + "</tr>\n";
}

std::string number_cell(std::size_t number) {
    return html_cell(std::to_string(number), std::to_string(number));
}

std::string remarks_list(const Inspection& inspection) {
    if (inspection.acceptance_remarks.empty()) return "";
    std::string html = "<ul>";
    for (const AcceptanceRemark& remark : inspection.acceptance_remarks)
        html += "<li>" + html_escaped(text_of(remark)) + "</li>";
    return html + "</ul>";
}

} // namespace

std::string html_findings(const Report& report) {
    const std::vector<Check> findings = whole_inspection(report).findings;
    if (findings.empty()) return "";
    std::string html = "<section><h2>Findings</h2>" +
                       html_table_head({"#", "where", "code", "value", "what", "place x, y, z"},
                                       {"where", "what"});
    for (std::size_t i = 0; i < findings.size(); ++i)
        html += row(report, findings[i], "finding-" + std::to_string(i + 1),
                    outcome_of(findings[i]), number_cell(i + 1), "");
    return html + std::string(html_table_end) + "</section>\n";
}

std::string html_accepted(const Report& report) {
    const Inspection whole = whole_inspection(report);
    if (whole.accepted.empty() && whole.acceptance_remarks.empty()) return "";
    std::string html =
        "<section id=\"accepted\"><h2>Accepted</h2><p class=\"soft\">Found, and accepted by a "
        "person: nothing here "
        "has a part in the verdict.</p>" +
        remarks_list(whole);
    if (whole.accepted.empty()) return html + "</section>\n";
    html +=
        html_table_head({"where", "code", "value", "what", "place x, y, z", "why", "by", "until"},
                        {"where", "what"});
    for (const Check& check : whole.accepted) {
        const AcceptanceNote& note = *check.accepted;
        html += row(report, check, "", "crease", "",
                    html_words_cell(note.why) + html_words_cell(note.who + ", " + note.when) +
                        html_words_cell(note.until.empty() ? "–" : note.until));
    }
    return html + std::string(html_table_end) + "</section>\n";
}

std::string html_looks(const Report& report) {
    const std::vector<Check>& looks = report.inspection.looks;
    if (looks.empty()) return "";
    std::string html =
        "<section><h2>Worth a look</h2><p class=\"soft\">Reported, not judged: "
        "nothing here has a part in the verdict.</p>" +
        html_table_head({"face", "code", "value", "what", "place x, y, z"}, {"face", "what"});
    for (const Check& look : looks) html += row(report, look, "", "undecided", "", "");
    return html + std::string(html_table_end) + "</section>\n";
}

} // namespace keiko
