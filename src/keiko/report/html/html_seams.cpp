#include "keiko/base/units.h"
#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/seam_quantities.h"
#include "keiko/report/content/profiles_text.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Tone of a seam: its verdict, or "crease" for scraps and passing creases.
std::string tone_of(const MeasuredSeam& seam) {
    if (seam.scrap || seam.is_passing_crease()) return "crease";
    return std::string(name_of(seam.verdict));
}

bool over(const MeasuredValue& worst) {
    return worst.verdict != Verdict::pass;
}

/// One measure against its limit, with a bar that is full at the limit.
std::string measure(std::string_view label, std::string_view tone, const std::string& value,
                    const std::string& note, double share_of_limit) {
    return "<div class=\"measure " + std::string(tone) + "\"><span class=\"soft\">" +
           std::string(label) + "</span> <b>" + value + "</b>" + html_bar(share_of_limit) +
           "<span class=\"soft small\">" + note + "</span></div>";
}

std::string gap_measure(const MeasuredSeam& seam) {
    const MeasuredValue& gap = seam.gap;
    return measure(seam.overlap && over(gap) ? "overlap" : "gap", name_of(gap.verdict),
                   fixed_number(gap.value, 4) + " mm", "limit " + short_number(gap.limit) + " mm",
                   share_of_limit(gap));
}

/// Shift of a lamp's image by a seam angle, for lamps 2 m away: docs/theory/verdict.md. Over a fold
/// no image is continued.
std::string lamp_shift(double degrees) {
    constexpr double lamp_distance = 2000; // mm
    constexpr double fold = 30;            // degrees
    if (degrees > fold) return "";
    const double shift = 2 * lamp_distance * std::tan(degrees_to_radians(degrees));
    return " · " + fixed_number(shift, 1) + " mm at 2 m";
}

std::string angle_measure(const MeasuredSeam& seam) {
    if (!seam.angle) return measure("angle", "crease", "–", "no normal on one side", 0);
    const MeasuredValue& angle = *seam.angle;
    const std::string value = fixed_number(angle.value, 3) + "°";
    if (seam.kind == SeamClass::crease)
        return measure("angle", "crease", value, "a crease, not judged", 1);
    if (seam.kind == SeamClass::run_out)
        return measure("angle", "crease", value, "fades out, judged with the crease", 1);
    return measure("angle", name_of(angle.verdict), value,
                   "limit " + short_number(angle.limit) + "°" + lamp_shift(angle.value),
                   share_of_limit(angle));
}

/// Radius across the seam on a side; those of both sides have one sign where they bend one way.
std::string radius_text(double curvature) {
    constexpr double flat = 1e-7, whole = 100; // 1/mm, mm
    if (std::abs(curvature) < flat) return "flat";
    const double radius = 1 / curvature;
    return "R " + (std::abs(radius) < whole ? short_number(radius) : fixed_number(radius, 0)) +
           " mm";
}

std::string curvature_measure(const MeasuredSeam& seam) {
    if (!seam.curvature)
        return measure("curvature", "crease", "–", "judged where gap and angle pass", 0);
    const CurvatureStep& step = *seam.curvature;
    return measure("curvature", name_of(step.worst.verdict),
                   fixed_number(step.mismatch * 100, 1) + " %",
                   radius_text(step.curvature_a) + " | " + radius_text(step.curvature_b) + ", " +
                       std::string(formula_text(step.formula)) + ", limit " +
                       short_number(step.worst.limit * 100) + " %" +
                       (step.flat ? ", against the flat radius" : ""),
                   share_of_limit(step.worst));
}

/// Cell of the fading; empty for a seam that is no crease, and for a crease that does not fade out.
std::string fading_measure(const MeasuredSeam& seam) {
    if (!seam.fading) return "";
    const MeasuredValue& worst = *seam.fading;
    return measure("run-out", name_of(worst.verdict), short_number(worst.value) + " °/mm",
                   "step of the slope, limit " + short_number(worst.limit) + " °/mm",
                   share_of_limit(worst));
}

/// Cell of the slope; empty if the preset does not judge it.
std::string slope_measure(const MeasuredSeam& seam, const CriteriaPreset& preset) {
    if (!preset.curvature_slope) return "";
    if (!seam.slope)
        return measure("curvature's slope", "crease", "–",
                       seam.curvature && seam.curvature->worst.verdict == Verdict::pass
                           ? "nearly flat, not judged"
                           : "judged where curvature passes",
                       0);
    const MeasuredValue& worst = seam.slope->worst;
    return measure("curvature's slope", name_of(worst.verdict), fixed_number(worst.value, 3) + "°",
                   "limit " + short_number(worst.limit) + "°", share_of_limit(worst));
}

/// Note on an irregular point: a subdivision surface has no curvature there, so a failed limit says
/// nothing about the cage.
std::string irregular_note(const MeasuredSeam& seam) {
    return seam.irregular ? ", at an irregular point of the cage" : "";
}

/// Note on unusual properties of the seam.
std::string kind_note(const MeasuredSeam& seam) {
    std::string note = seam.internal ? " · a knot line inside the face" : "";
    if (seam.kind == SeamClass::fold)
        note += " · folded back";
    else if (seam.overlap && over(seam.gap))
        note += " · one side lies on the other";
    if (seam.parted) note += " · wider than the join distance";
    return note;
}

/// The plots of a stretch, if the report has its profile.
std::string profile_of(const Report& report, std::uint32_t index) {
    const auto found =
        std::find_if(report.profiles.begin(), report.profiles.end(),
                     [index](const SeamProfile& profile) { return profile.seam == index; });
    if (found == report.profiles.end()) return "";
    const Inspection& inspection = report.inspection;
    const CriteriaPreset& limits = limits_of(inspection, inspection.seams[index]);
    return profile_svg(*found, SeamQuantities(limits).curvature_limit().formula);
}

/// The plots of a stretch, folded.
std::string folded_profile_of(const Report& report, std::uint32_t index) {
    const std::string plots = profile_of(report, index);
    return plots.empty() ? ""
                         : "<details><summary>all along the seam</summary>" + plots + "</details>";
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
    const std::string tone = accepted ? "accepted" : seam.scrap ? "scrap" : tone_of(seam);
    const bool crease = accepted || tone_of(seam) == "crease";
    const double rank = crease ? -1 : static_cast<double>(seam.verdict);
    const double within = 1 - 1 / (1 + seam.severity);
    return html_cell(short_number(rank + within, 9), "<span class=\"chip\">" + tone + "</span>");
}

std::string row(const Report& report, std::size_t index, bool with_slope) {
    const MeasuredSeam& seam = report.inspection.seams[index];
    const std::size_t number = index + 1;
    const std::string none = html_cell("", "–");
    const bool accepted = is_accepted_seam(report.inspection, static_cast<std::uint32_t>(index));
    std::string html = "<tr class=\"" + (accepted ? "crease" : tone_of(seam)) + "\"" +
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
    return "<section><h2>" + title + "</h2>" + note + html_table_head(headings(preset), "faces") +
           rows + std::string(html_table_end) + "</section>\n";
}

} // namespace

std::string html_seam_card(const Report& report, std::size_t rank, std::uint32_t index,
                           const std::string& note) {
    const MeasuredSeam& seam = report.inspection.seams[index];
    return "<div class=\"card seam " + tone_of(seam) + "\"><div class=\"rank\">" +
           std::to_string(rank) + "</div><div class=\"body\"><div class=\"name\">" +
           html_escaped(seam.faces) + "</div>" + note + "<div class=\"soft small\">at " +
           place_text(worst_place(seam)) + irregular_note(seam) + " · " +
           fixed_number(seam.length, 1) + " mm long" + kind_note(seam) +
           "</div><div class=\"measures\">" + gap_measure(seam) + angle_measure(seam) +
           curvature_measure(seam) + slope_measure(seam, limits_of(report.inspection, seam)) +
           fading_measure(seam) + "</div>" + folded_profile_of(report, index) + "</div>" +
           html_close_up(report, CloseUp::Of::seam, index) + "</div>\n";
}

std::string html_more_profiles(const Report& report) {
    const std::vector<ShownItem> shown = shown_items(report);
    std::string html;
    for (const SeamProfile& profile : report.profiles) {
        if (std::any_of(shown.begin(), shown.end(),
                        [&](const ShownItem& item) { return item.seam == profile.seam; }))
            continue;
        const MeasuredSeam& seam = report.inspection.seams[profile.seam];
        html += "<details class=\"card profiled\"><summary><span class=\"" + tone_of(seam) +
                "\"><span class=\"chip\">" + tone_of(seam) + "</span></span> " +
                std::to_string(profile.seam + 1) + " · " + html_escaped(seam.faces) + "</summary>" +
                profile_of(report, profile.seam) + "</details>\n";
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
