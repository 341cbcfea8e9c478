#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <map>

namespace keiko {
namespace {

/// "three-quarter front left" for "standing-three-quarter-front-left".
std::string words_of_view(const std::string& view) {
    constexpr std::string_view standing = "standing-", side = "three-quarter-";
    std::string words = view.rfind(standing, 0) == 0 ? view.substr(standing.size()) : view;
    const bool is_between = words.rfind(side, 0) == 0;
    if (is_between) words.erase(0, side.size());
    std::replace(words.begin(), words.end(), '-', ' ');
    return is_between ? "three-quarter " + words : words;
}

/// Sight of a fault in words: "curvature · breaks a reflection by up to 2.8′ (arc minutes),
/// seen from left · 271.5 mm on 3 stretches, 96 % of it visible · on both sides".
std::string sight_text(const TriageItem& item) {
    constexpr double least_width = 0.05, coarse = 10; // arc minutes
    std::string text(name_of(item.mending));
    if (item.width >= least_width)
        text += (item.mending == Mending::position ? " · counts as a break of a reflection by "
                                                   : " · breaks a reflection by up to ") +
                fixed_number(item.width, item.width < coarse ? 1 : 0) +
                "′ (arc minutes), seen from " + words_of_view(item.view);
    if (!item.seams.empty())
        text += " · " + fixed_number(item.length, 1) + " mm on " +
                std::to_string(item.seams.size()) +
                (item.seams.size() == 1 ? " stretch" : " stretches") + ", " +
                fixed_number(100 * item.visible, 0) + " % of it visible";
    return text + (item.mirrored ? " · on both sides" : "");
}

std::string note_on(const TriageItem& fault) {
    return "<div class=\"sight\">" + html_escaped(sight_text(fault)) + "</div>";
}

/// The card of a fault of a face, or of lines.
std::string card(const Report& report, std::size_t rank, const ShownItem& item,
                 const Check& worst) {
    return "<div class=\"card seam " + std::string(outcome_of(worst)) + "\"><div class=\"rank\">" +
           std::to_string(rank) + "</div><div class=\"body\"><div class=\"name\">" +
           html_escaped(worst.faces) + "</div>" + note_on(*item.fault) + "<div>" +
           html_escaped(worst.message) + "</div><div class=\"soft small\">at " +
           place_text(worst.worst.place) + "</div></div>" +
           html_close_up(report, CloseUp::Of::face, item.face) + "</div>\n";
}

/// "Worth a look besides, not judged: 4 × KEIKO-OPENING, 1 × KEIKO-DENT."
std::string looks_line(const Inspection& inspection) {
    std::map<std::string, std::size_t> counts;
    for (const Check& look : inspection.looks) ++counts[look.code];
    if (counts.empty()) return "";
    std::string text;
    for (const auto& [code, count] : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " × " + code;
    return "<p class=\"soft\">Worth a look besides, not judged: " + html_escaped(text) + ".</p>";
}

std::string row(std::size_t number, const TriageItem& fault, const Check& worst) {
    return "<tr class=\"" + std::string(outcome_of(worst)) + "\">" +
           html_cell(std::to_string(number), std::to_string(number)) +
           html_words_cell(worst.faces) + html_words_cell(std::string(name_of(fault.mending))) +
           html_words_cell(worst.message) +
           html_number_cell(fault.length, fixed_number(fault.length, 1), true) +
           html_place_cell(worst.worst.place) + "</tr>\n";
}

} // namespace

std::string html_first_screen(const Report& report) {
    const std::vector<ShownItem> items = shown_items(report);
    if (items.empty()) return "";
    const std::size_t faults = report.triage.items.size();
    const std::vector<Check> findings = whole_inspection(report).findings;
    std::string html = faults > 0
                           ? "<section><h2>What to mend first</h2><p class=\"soft\">Faults by what "
                             "an eye sees of them from the standing views: how far the reflection "
                             "of a lamp breaks, over the visible length. A gap counts as the angle "
                             "that is as many times over its limit.</p>"
                           : "<section><h2>Worst stretches of seams</h2>";
    html += "<div class=\"worst\">\n";
    for (std::size_t i = 0; i < items.size(); ++i) {
        const ShownItem& item = items[i];
        html +=
            item.seam != no_index
                ? html_seam_card(report, i + 1, item.seam, item.fault ? note_on(*item.fault) : "")
                : card(report, i + 1, item, findings[item.fault->findings.front()]);
    }
    html += "</div>";
    if (faults > items.size())
        html += "<p class=\"soft\">" + std::to_string(faults - items.size()) +
                " more stand among the findings below.</p>";
    return html + looks_line(report.inspection) + "</section>\n";
}

std::string html_hidden(const Report& report) {
    const std::vector<TriageItem>& hidden = report.triage.hidden;
    if (hidden.empty()) return "";
    const std::vector<Check> findings = whole_inspection(report).findings;
    std::string html =
        "<section><h2>Faults in hidden places</h2><p class=\"soft\">No standing view shows more "
        "than a hundredth of their length from outside: flanges, hems, inner sides. They have "
        "their part in the verdict.</p>" +
        html_table_head({"#", "faces", "mend", "what", "length mm", "place x, y, z"}, "faces");
    for (std::size_t i = 0; i < hidden.size(); ++i)
        html += row(i + 1, hidden[i], findings[hidden[i].findings.front()]);
    return html + std::string(html_table_end) + "</section>\n";
}

} // namespace keiko
