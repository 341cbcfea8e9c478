#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/html/fault_words.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <map>
#include <set>
#include <span>

namespace keiko {
namespace {

std::string sight_note(const TriageItem& fault, const Inspection& inspection) {
    return "<div class=\"sight\">" + html_escaped(sight_text(fault, inspection)) + "</div>";
}

/// "Kink (G1) · rear right, high · "
std::string heading(const TriageItem& fault, const Inspection& inspection) {
    return html_escaped(fault_title(fault, inspection) + " · " +
                        words_of_place(fault.place, inspection.facts.bounds) + " · ");
}

std::string also_note(const TriageItem& fault, const Inspection& inspection) {
    const std::string also = also_text(fault, inspection);
    return also.empty() ? "" : "<div class=\"soft small\">" + html_escaped(also) + "</div>";
}

/// The card of a fault of a face, or of lines.
std::string card(const Report& report, std::size_t rank, const ShownItem& item,
                 const Inspection& whole) {
    const Check& worst = numbered_check(whole, item.fault->findings.front());
    return "<div class=\"card seam " + std::string(outcome_of(worst)) + "\"><div class=\"rank\">" +
           std::to_string(rank) + "</div><div class=\"body\"><div class=\"name\">" +
           heading(*item.fault, whole) + html_escaped(worst.faces) + "</div>" +
           sight_note(*item.fault, whole) + "<div>" + html_escaped(message_of_worst(worst)) +
           "</div>" + also_note(*item.fault, whole) + "<div class=\"soft small\">at " +
           place_with_axes(worst.worst.place) + "</div></div>" +
           html_close_up(report, CloseUp::Of::face, item.face, item.place) + "</div>\n";
}

/// "Worth a look besides, not judged: 4 × KEIKO-TEE, 1 × KEIKO-DENT." Those of faults are left out.
std::string looks_line(const Triage& triage, const Inspection& whole) {
    std::set<std::size_t> of_faults;
    for (const auto* faults : {&triage.items, &triage.hidden})
        for (const TriageItem& fault : *faults)
            of_faults.insert(fault.findings.begin(), fault.findings.end());
    std::map<std::string, std::size_t> counts;
    for (std::size_t i = 0; i < whole.looks.size(); ++i)
        if (of_faults.count(whole.findings.size() + i) == 0) ++counts[whole.looks[i].code];
    if (counts.empty()) return "";
    std::string text;
    for (const auto& [code, count] : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " × " + code;
    return "<p class=\"soft\">Worth a look besides, not judged: " + html_escaped(text) + ".</p>";
}

/// The seam or the face that shows most of a fault.
std::string faces_of(const TriageItem& fault, const Check& worst) {
    const bool is_of_seam = fault.face == no_index && !fault.seams.empty();
    return (is_of_seam ? "seam " + std::to_string(fault.seams.front() + 1) + " · " : "") +
           worst.faces;
}

/// A row of a table of faults.
std::string row(std::size_t number, const TriageItem& fault, const Inspection& whole) {
    const Check& worst = numbered_check(whole, fault.findings.front());
    return "<tr class=\"" + std::string(outcome_of(worst)) + "\">" +
           html_cell(std::to_string(number), std::to_string(number)) +
           html_words_cell(fault_title(fault, whole)) +
           html_number_cell(worst.worst.value, value_text(worst), true) +
           html_words_cell(faces_of(fault, worst)) +
           html_number_cell(fault.weight, fixed_number(fault.weight, 1) + "′", false) +
           html_words_cell(words_of_view(fault.view)) +
           html_number_cell(fault.length, fixed_number(fault.length, 1), false) +
           html_place_cell(worst.worst.place) + "</tr>\n";
}

/// Faults in a table, numbered from `first` on.
std::string table_of(std::span<const TriageItem> faults, std::size_t first,
                     const Inspection& whole) {
    std::string html = html_table_head(
        {"#", "fault", "worst", "faces", "weight", "seen from", "length mm", "place x, y, z"},
        {"fault", "faces", "seen from"});
    for (std::size_t i = 0; i < faults.size(); ++i) html += row(first + i, faults[i], whole);
    return html + std::string(html_table_end);
}

/// The heading of the first screen, and the order of its faults in words.
std::string_view introduction(const Report& report) {
    if (report.triage.items.empty()) return "<h2>Worst stretches of seams</h2>";
    return "<h2>What to mend first</h2><p class=\"soft\">Faults by what an eye sees of them from "
           "the standing views: how far the reflection of a lamp breaks. The weight is the break, "
           "in arc minutes, that is as easily seen along one degree. A change of a stripe's width "
           "counts a twelfth of a tear. A gap counts half of the angle that is as far over its "
           "limit, and a hole too. In the pictures yellow dots are the seams of a fault, and a "
           "ring is about a hole or a face. Cards are red at the side where a limit is not kept, "
           "amber where it is undecided or not judged.</p>";
}

/// The card of an item of the first screen.
std::string card_of(const Report& report, std::size_t rank, const ShownItem& item,
                    const Inspection& whole) {
    if (item.seam == no_index) return card(report, rank, item, whole);
    if (!item.fault) return html_seam_card(report, rank, item, "", "");
    return html_seam_card(report, rank, item, heading(*item.fault, whole),
                          sight_note(*item.fault, whole) + also_note(*item.fault, whole));
}

} // namespace

std::string html_first_screen(const Report& report) {
    const std::vector<ShownItem> items = shown_items(report);
    if (items.empty()) return "";
    const Inspection whole = whole_inspection(report);
    std::string html = "<section>" + std::string(introduction(report)) +
                       html_figures(report.standing_pictures) + "<div class=\"worst\">\n";
    for (std::size_t i = 0; i < items.size(); ++i) html += card_of(report, i + 1, items[i], whole);
    return html + "</div>" + looks_line(report.triage, whole) + "</section>\n";
}

std::string html_more_faults(const Report& report) {
    const std::span<const TriageItem> faults = report.triage.items;
    if (faults.size() <= most_shown) return "";
    return html_section(
        "What comes after them",
        table_of(faults.subspan(most_shown), most_shown + 1, whole_inspection(report)));
}

std::string html_hidden(const Report& report) {
    const std::vector<TriageItem>& hidden = report.triage.hidden;
    if (hidden.empty()) return "";
    return html_section(
        "Faults in hidden places",
        "<p class=\"soft\">No standing view shows more than a hundredth of their length from "
        "outside: flanges, hems, inner sides. Findings among them have their part in the "
        "verdict.</p>" +
            table_of(hidden, report.triage.items.size() + 1, whole_inspection(report)));
}

} // namespace keiko
