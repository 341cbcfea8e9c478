#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_seam_parts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

bool over(const MeasuredValue& worst) {
    return worst.verdict != Verdict::pass;
}

/// Cell sorted by the ratio to its limit.
std::string curvature_cell(const CurvatureStep& step) {
    return html_number_cell(share_of_limit(step.worst), fixed_number(step.mismatch * 100, 1) + " %",
                            over(step.worst));
}

std::string kind_of(const MeasuredSeam& seam) {
    std::string kind = seam.internal ? "knot line" : "seam";
    if (seam.kind != SeamClass::smooth) kind += ", " + std::string(name_of(seam.kind));
    return kind + (seam.overlap ? ", overlap" : "") + (seam.parted ? ", parted" : "");
}

/// Cell sorted from good to bad: scraps and creases, pass, undecided, fail, each by its ratio to
/// the limit.
std::string verdict_cell(const MeasuredSeam& seam, bool accepted) {
    const std::string tone = accepted ? "accepted" : seam.scrap ? "scrap" : seam_tone(seam);
    const bool crease = accepted || seam_tone(seam) == "crease";
    const double rank = crease ? -1 : static_cast<double>(seam.verdict);
    const double within = 1 - 1 / (1 + seam.severity);
    return html_cell(short_number(rank + within, 9), "<span class=\"chip\">" + tone + "</span>");
}

std::string row(const Report& report, std::size_t index, bool with_slope) {
    const MeasuredSeam& seam = report.inspection.seams[index];
    const std::size_t number = index + 1;
    const std::string none = html_cell("", "–");
    const bool accepted = is_accepted_seam(report.inspection, static_cast<std::uint32_t>(index));
    std::string html = "<tr class=\"" + (accepted ? "crease" : seam_tone(seam)) + "\"" +
                       html_opens_close_up(report, CloseUp::Of::seam, index) + ">" +
                       html_cell(std::to_string(number), std::to_string(number)) +
                       html_words_cell(seam.faces) + html_cell(kind_of(seam), kind_of(seam)) +
                       verdict_cell(seam, accepted);
    html += html_number_cell(seam.gap.value, fixed_number(seam.gap.value, 4),
                             !seam.scrap && over(seam.gap));
    html += seam.angle ? html_number_cell(seam.angle->value, fixed_number(seam.angle->value, 3),
                                          seam.is_angle_judged() && over(*seam.angle))
                       : none;
    html += seam.curvature ? curvature_cell(*seam.curvature) : none;
    if (with_slope)
        html += seam.slope ? html_number_cell(seam.slope->worst.value,
                                              fixed_number(seam.slope->worst.value, 3),
                                              over(seam.slope->worst))
                           : none;
    html += seam.fading ? html_number_cell(seam.fading->value, short_number(seam.fading->value),
                                           !seam.scrap && over(*seam.fading))
                        : none;
    html += html_number_cell(seam.length, fixed_number(seam.length, 1), false);
    const Vec3 place = worst_place(seam);
    return html + html_cell(short_number(place.x, 9), place_text(place) + irregular_note(seam)) +
           "</tr>\n";
}

/// The columns, with their limits if these are the same for all.
std::vector<std::string> headings(const CriteriaPreset& preset) {
    const auto with = [&](const std::string& name, double limit, const char* unit = "") {
        return with_limit(name, " ≤ " + short_number(limit) + unit, preset);
    };
    std::vector<std::string> names{"#",
                                   "faces",
                                   "kind",
                                   "verdict",
                                   with("gap mm", preset.gap),
                                   with("angle °", preset.angle),
                                   "curvature"};
    if (preset.curvature) names.back() = with("curvature", preset.curvature->limit * 100, " %");
    if (judges_slopes(preset))
        names.push_back(with("its slope °", preset.curvature_slope.value_or(0)));
    names.push_back(with("fading °/mm", preset.fading));
    names.insert(names.end(), {"length mm", "worst place x, y, z"});
    return names;
}

/// The rows of scraps, or of all other stretches; empty without any.
std::string seam_table(const Report& report, const std::string& title, const std::string& note,
                       bool scraps) {
    const std::vector<MeasuredSeam>& seams = report.inspection.seams;
    const CriteriaPreset& preset = report.inspection.preset;
    std::string rows;
    for (std::size_t i = 0; i < seams.size(); ++i)
        if (seams[i].scrap == scraps) rows += row(report, i, judges_slopes(preset));
    if (rows.empty()) return "";
    return "<section id=\"" + std::string(scraps ? "scraps" : "seams") + "\"><h2>" + title +
           "</h2>" + note + html_table_head(headings(preset), {"faces"}) + rows +
           std::string(html_table_end) + "</section>\n";
}

} // namespace

std::string html_more_profiles(const Report& report) {
    const std::vector<ShownItem> shown = shown_items(report);
    std::string html;
    for (const SeamProfile& profile : report.profiles) {
        if (std::any_of(shown.begin(), shown.end(),
                        [&](const ShownItem& item) { return item.seam == profile.seam; }))
            continue;
        const MeasuredSeam& seam = report.inspection.seams[profile.seam];
        html += "<details class=\"card profiled\"><summary><span class=\"" + seam_tone(seam) +
                "\"><span class=\"chip\">" + seam_tone(seam) + "</span></span> " +
                std::to_string(profile.seam + 1) + " · " + html_escaped(seam.faces) + "</summary>" +
                plots_of(report, profile.seam) + "</details>\n";
    }
    if (html.empty()) return "";
    return "<section><h2>Profiles of further stretches</h2>\n" + html + "</section>\n";
}

std::string html_all_seams(const Report& report) {
    return seam_table(report, "All stretches of seams", "", false);
}

std::string html_scraps(const Report& report) {
    return seam_table(report, "Scraps",
                      "<p class=\"soft\">Stretches shorter than " +
                          short_number(report.inspection.preset.negligible) +
                          " mm. They are no findings one by one, but count together where they "
                          "stand close.</p>",
                      true);
}

} // namespace keiko
