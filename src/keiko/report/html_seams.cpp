#include "keiko/base/units.h"
#include "keiko/inspect/curvature_match.h"
#include "keiko/report/base64.h"
#include "keiko/report/html_sections.h"
#include "keiko/report/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

/// How a seam is shown: by its verdict, a passing crease apart.
std::string tone_of(const MeasuredSeam& seam) {
    if (seam.crease && seam.verdict == Verdict::pass) return "crease";
    return std::string(name_of(seam.verdict));
}

/// One measure against its limit, with a bar that is full at the limit.
std::string measure(std::string_view label, std::string_view tone, const std::string& value,
                    const std::string& note, double share_of_limit) {
    return "<div class=\"measure " + std::string(tone) + "\"><span class=\"soft\">" +
           std::string(label) + "</span> <b>" + value + "</b>" + html_bar(share_of_limit) +
           "<span class=\"soft small\">" + note + "</span></div>";
}

std::string gap_measure(const Worst& gap) {
    return measure("gap", name_of(gap.verdict), fixed_number(gap.value, 4) + " mm",
                   "limit " + short_number(gap.limit) + " mm", gap.value / gap.limit);
}

/// A seam angle moves a lamp's image by twice the angle times its distance.
std::string lamp_shift(double degrees) {
    constexpr double lamp_distance = 2000; // mm
    return fixed_number(2 * degrees_to_radians(degrees) * lamp_distance, 1) + " mm at 2 m";
}

std::string angle_measure(const MeasuredSeam& seam) {
    if (!seam.angle) return measure("angle", "crease", "–", "no normal on one side", 0);
    const Worst& angle = *seam.angle;
    const std::string value = fixed_number(angle.value, 3) + "°";
    if (seam.crease) return measure("angle", "crease", value, "a crease, not judged", 1);
    return measure("angle", name_of(angle.verdict), value,
                   "limit " + short_number(angle.limit) + "° · " + lamp_shift(angle.value),
                   angle.value / angle.limit);
}

std::string curvature_measure(const MeasuredSeam& seam) {
    if (!seam.curvature)
        return measure("curvature", "crease", "–", "judged where gap and angle pass", 0);
    const CurvatureStep& step = *seam.curvature;
    const double share = step.worst.value / step.worst.limit;
    if (step.flat)
        return measure(
            "curvature", name_of(step.worst.verdict), short_number(step.worst.value) + " /mm",
            "|C1-C2|, limit " + short_number(step.worst.limit) + " /mm (nearly flat)", share);
    return measure("curvature", name_of(step.worst.verdict),
                   fixed_number(step.mismatch * 100, 1) + " %",
                   std::string(formula_text(step.formula)) + ", limit " +
                       short_number(step.worst.limit * 100) + " %",
                   share);
}

std::string close_up(const Report& report, std::uint32_t seam) {
    for (const SeamPicture& picture : report.close_ups)
        if (picture.seam == seam)
            return "<img alt=\"close-up\" src=\"data:image/png;base64," +
                   base64(picture.picture.png) + "\">";
    return "";
}

/// Where a subdivision surface has no curvature a failed limit says nothing of the cage.
std::string irregular_note(const MeasuredSeam& seam) {
    return seam.irregular ? ", at an irregular point of the cage" : "";
}

std::string seam_card(const Report& report, std::size_t rank, std::uint32_t index) {
    const MeasuredSeam& seam = report.inspection.seams[index];
    return "<div class=\"card seam " + tone_of(seam) + "\"><div class=\"rank\">" +
           std::to_string(rank) + "</div><div class=\"body\"><div class=\"name\">" +
           html_escaped(seam.faces) + "</div><div class=\"soft small\">at " +
           place_text(worst_place(seam)) + irregular_note(seam) + " · " +
           fixed_number(seam.length, 1) + " mm long</div><div class=\"measures\">" +
           gap_measure(seam.gap) + angle_measure(seam) + curvature_measure(seam) + "</div></div>" +
           close_up(report, index) + "</div>\n";
}

std::string cell(const std::string& sort_key, const std::string& text,
                 std::string_view classes = "") {
    const std::string named = classes.empty() ? "" : " class=\"" + std::string(classes) + "\"";
    return "<td" + named + " data-v=\"" + sort_key + "\">" + text + "</td>";
}

std::string number_cell(double value, const std::string& text, bool over) {
    return cell(short_number(value, 9), text, over ? "tone" : "");
}

bool over(const Worst& worst) {
    return worst.verdict != Verdict::pass;
}

std::string row(std::size_t number, const MeasuredSeam& seam) {
    const std::string tone = tone_of(seam);
    std::string html = "<tr class=\"" + tone + "\">" +
                       cell(std::to_string(number), std::to_string(number)) +
                       cell(html_escaped(seam.faces), html_escaped(seam.faces), "left") +
                       cell(tone, "<span class=\"chip\">" + tone + "</span>");
    html += number_cell(seam.gap.value, fixed_number(seam.gap.value, 4), over(seam.gap));
    html += seam.angle ? number_cell(seam.angle->value, fixed_number(seam.angle->value, 3),
                                     !seam.crease && over(*seam.angle))
                       : cell("", "–");
    html += seam.curvature ? number_cell(seam.curvature->mismatch,
                                         fixed_number(seam.curvature->mismatch * 100, 1),
                                         over(seam.curvature->worst))
                           : cell("", "–");
    html += number_cell(seam.length, fixed_number(seam.length, 1), false);
    const Vec3 place = worst_place(seam);
    return html + cell(short_number(place.x, 9), place_text(place) + irregular_note(seam)) +
           "</tr>\n";
}

} // namespace

std::string html_worst_seams(const Report& report) {
    const std::vector<std::uint32_t> worst = worst_seams(report.inspection, worst_seam_count);
    if (worst.empty()) return "";
    std::string html = "<section><h2>Worst seams</h2><div class=\"worst\">\n";
    for (std::size_t i = 0; i < worst.size(); ++i) html += seam_card(report, i + 1, worst[i]);
    return html + "</div></section>\n";
}

std::string html_all_seams(const Report& report) {
    const std::vector<MeasuredSeam>& seams = report.inspection.seams;
    if (seams.empty()) return "";
    std::string html = "<section><h2>All seams</h2><div class=\"card scroll\"><table><thead><tr>";
    for (const std::string_view name : {"#", "faces", "verdict", "gap mm", "angle °", "curvature %",
                                        "length mm", "worst place x, y, z"})
        html += "<th" + std::string(name == "faces" ? " class=\"left\"" : "") +
                "><button type=\"button\">" + std::string(name) + "</button></th>";
    html += "</tr></thead><tbody>\n";
    for (std::size_t i = 0; i < seams.size(); ++i) html += row(i + 1, seams[i]);
    return html + "</tbody></table></div></section>\n";
}

} // namespace keiko
