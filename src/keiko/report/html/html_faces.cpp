#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

std::string no_cell() {
    return html_cell("", "–");
}

std::string soft_note(const std::string& text) {
    return " <span class=\"soft small\">" + text + "</span>";
}

/// The value and, if it is undecided, the largest distance of the true one beyond it.
std::string extreme(const CurvatureExtreme& k, double direction) {
    std::string text = short_number(k.value);
    if (k.undecided && std::isfinite(k.bound))
        text += soft_note("to " + short_number(k.value + direction * k.bound));
    else if (k.undecided)
        text += soft_note("no bound");
    return html_number_cell(k.value, text, false);
}

std::string curvature_cells(const MeasuredFace& face) {
    if (!face.curvature) return no_cell() + no_cell() + no_cell() + no_cell();
    const FaceCurvature& c = *face.curvature;
    return extreme(c.largest, 1) + extreme(c.smallest, -1) + extreme(c.largest_gaussian, 1) +
           extreme(c.smallest_gaussian, -1);
}

/// The radius found and, if it is undecided, the smallest possible true one.
std::string radius_cell(const MeasuredValue& radius) {
    std::string text = short_number(radius.value, 4);
    if (radius.bound > curvature_tolerance * radius.value)
        text += soft_note("to " + short_number(radius.value - radius.bound, 4));
    return html_number_cell(radius.value, text, radius.verdict != Verdict::pass);
}

/// The draft found and, if it is undecided, the smallest possible true one.
std::string draft_cell(const MeasuredValue& draft) {
    std::string text = fixed_number(draft.value, 2);
    if (draft.verdict == Verdict::undecided)
        text += soft_note("to " + fixed_number(draft.value - draft.bound, 2));
    text += soft_note("at " + place_text(draft.place));
    return html_number_cell(draft.value, text, draft.verdict != Verdict::pass);
}

bool judges_draft(const Inspection& inspection) {
    return std::any_of(inspection.faces.begin(), inspection.faces.end(),
                       [](const MeasuredFace& face) { return face.draft.has_value(); });
}

std::string draft_heading(const CriteriaPreset& preset) {
    const std::string name = "smallest draft °";
    const auto& limit = preset.surface.draft;
    return limit ? with_limit(name, " ≥ " + short_number(limit->angle), preset) : name;
}

std::string flaw_cell(const MeasuredFace& face) {
    if (face.flaws.empty()) return no_cell();
    const Flaw& flaw = face.flaws.front();
    if (!flaw.is_searched()) return html_number_cell(0, "not searched", true);
    const std::string more =
        face.flaws.size() > 1 ? " and " + std::to_string(face.flaws.size() - 1) + " more" : "";
    return html_number_cell(
        flaw.depth.value,
        short_number(flaw.depth.value, 3) + soft_note("at " + place_text(flaw.depth.place) + more),
        flaw.depth.verdict != Verdict::pass);
}

/// The length of all inflections, and the place of the longest.
std::string inflections_cell(const MeasuredFace& face) {
    if (face.inflections.empty()) return no_cell();
    double length = 0;
    for (const InflectionCurve& curve : face.inflections) length += curve.length;
    const std::vector<Vec3>& longest = face.inflections.front().points;
    return html_number_cell(
        length,
        fixed_number(length, 1) + soft_note("in " + std::to_string(face.inflections.size()) +
                                            " at " + place_text(longest[longest.size() / 2])),
        false);
}

std::string row(const Report& report, std::size_t index) {
    const MeasuredFace& face = report.inspection.faces[index];
    const CriteriaPreset& preset = report.inspection.preset;
    const bool accepted = is_accepted_face(report.inspection, static_cast<std::uint32_t>(index));
    const std::string verdict(accepted ? "accepted" : name_of(face.verdict));
    std::string html = "<tr class=\"" + (accepted ? "crease" : verdict) + "\"" +
                       html_opens_close_up(report, CloseUp::Of::face, index) + ">" +
                       html_cell(std::to_string(face.id), html_escaped(face.name), "left") +
                       html_cell(std::to_string(static_cast<int>(face.verdict)),
                                 "<span class=\"chip\">" + verdict + "</span>");
    html += (face.radius ? radius_cell(*face.radius) : no_cell()) + curvature_cells(face) +
            inflections_cell(face);
    if (judges_draft(report.inspection)) html += face.draft ? draft_cell(*face.draft) : no_cell();
    if (searches_flaws(preset)) html += flaw_cell(face);
    html += face.radius ? html_place_cell(face.radius->place) : no_cell();
    return html + "</tr>\n";
}

std::string radius_heading(const CriteriaPreset& preset) {
    const auto& limit = preset.surface.minimum_radius;
    const std::string name = "smallest radius mm";
    return limit ? with_limit(name, " ≥ " + short_number(*limit), preset) : name;
}

/// "dents, waves mm ≤ 0.01 in 100, 0.025 in 250"
std::string waviness_heading(const std::vector<WavinessLimit>& limits) {
    if (limits.size() == 1) return "dents, waves mm ≤ " + short_number(limits.front().depth);
    std::string heading = "dents, waves mm";
    for (const WavinessLimit& limit : limits)
        heading += (&limit == &limits.front() ? " ≤ " : ", ") + short_number(limit.depth) + " in " +
                   short_number(limit.window);
    return heading;
}

} // namespace

std::string html_faces(const Report& report) {
    const std::vector<MeasuredFace>& faces = report.inspection.faces;
    if (faces.empty()) return "";
    const CriteriaPreset& preset = report.inspection.preset;
    std::vector<std::string> headings{"face",
                                      "verdict",
                                      radius_heading(preset),
                                      "curvature 1/mm, largest",
                                      "smallest",
                                      "Gaussian 1/mm², largest",
                                      "smallest",
                                      "inflections mm"};
    if (judges_draft(report.inspection)) headings.push_back(draft_heading(preset));
    if (searches_flaws(preset))
        headings.push_back(preset.zones.empty() ? waviness_heading(preset.flaw_limits())
                                                : "dents, waves mm");
    headings.push_back("tightest place x, y, z");
    std::string html =
        "<section id=\"faces\"><h2>All faces</h2>" + html_table_head(headings, {"face"});
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (faces[i].in_scope) html += row(report, i);
    return html + std::string(html_table_end) + "</section>\n";
}

} // namespace keiko
