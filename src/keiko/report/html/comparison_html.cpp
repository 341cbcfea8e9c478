#include "keiko/report/content/comparison.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

/// "1 seam worse", "2 seams worse"
std::string count(const std::string& tone, std::size_t number, const std::string& noun,
                  const std::string& what) {
    return "<div class=\"card count " + tone + (number == 0 ? " none" : "") + "\"><b>" +
           std::to_string(number) + "</b>" + noun + (number == 1 ? " " : "s ") + what + "</div>";
}

std::size_t of_trend(const Comparison& c, SeamTrend trend) {
    std::size_t number = 0;
    for (const SeamChange& change : c.seams.changed) number += change.trend == trend;
    return number;
}

std::string head(const Comparison& c) {
    const bool same = c.same();
    std::string html = "<header class=\"card head " + std::string(same ? "pass" : "fail") +
                       "\"><div class=\"verdict\">" + (same ? "same" : "different") +
                       "</div><div class=\"names\"><h1>" + html_escaped(c.after) +
                       "</h1><div class=\"soft\">compared with " + html_escaped(c.before) +
                       "</div></div></header>\n<div class=\"counts\">";
    const std::size_t faces = faces_gone(c).size() + faces_new(c).size() + faces_turned(c).size();
    html +=
        count("fail", faces, "face", "gone, new or turned") +
        count("fail", of_trend(c, SeamTrend::worse), "seam", "worse") +
        count("pass", of_trend(c, SeamTrend::better), "seam", "better") +
        count("undecided", c.seams.removed.size() + c.seams.added.size(), "seam", "gone or new") +
        count("fail", c.seams.new_findings.size(), "finding", "new") +
        count("pass", c.seams.solved_findings.size(), "finding", "fixed");
    return html + "</div>\n";
}

std::string alignment(const Comparison& c) {
    if (!c.alignment) return "";
    return "<p>The part after was " + html_escaped(alignment_words(*c.alignment)) + ".</p>";
}

std::string_view png(const Comparison& c, const std::string& name) {
    const auto found = c.pngs.find(name);
    return found == c.pngs.end() ? std::string_view() : std::string_view(found->second);
}

std::string maps(const Comparison& c) {
    const std::string caption =
        "distance of after from before: red outside, blue inside; magenta: nothing within " +
        short_number(c.deviation.reach) + " mm";
    std::vector<DeviationMapFigure> figures;
    for (const ComparedView& view : c.views)
        figures.push_back({view.picture.view, png(c, view.map), view.map_width, view.map_height});
    return html_maps(figures, caption);
}

std::string view_section(const Comparison& c, const ComparedView& view) {
    const PictureOutcome& picture = view.picture;
    std::string html = "<section><h2>View " + html_escaped(picture.view) + "</h2>";
    if (!picture.problem.empty()) html += "<p>" + html_escaped(picture.problem) + "</p>";
    html += html_slider({png(c, picture.before), png(c, picture.after), png(c, picture.difference),
                         picture.width, picture.height},
                        picture.view);
    if (!picture.layers.empty()) html += html_layers(picture);
    const std::string lines = html_line_shifts(view, c.tolerance);
    if (!lines.empty())
        html += "<p class=\"small soft\">Reflection lines, on the part:</p>" + lines;
    return html + "</section>\n";
}

std::string list(const std::string& word, const std::vector<std::string>& faces) {
    std::string html;
    for (const std::string& face : faces)
        html += "<li>" + word + ": " + html_escaped(face) + "</li>";
    return html;
}

/// The parts of both bodies that were compared, and their zones.
std::string scope(const Comparison& c) {
    std::string items;
    for (const auto* inspection : {&c.inspection_before, &c.inspection_after})
        for (const std::string& sentence : scope_sentences(inspection->scope, inspection->preset))
            items += std::string("<li>") +
                     (inspection == &c.inspection_before ? "before: " : "after: ") +
                     html_escaped(sentence) + "</li>";
    return items.empty() ? "" : "<ul>" + items + "</ul>";
}

std::string faces(const Comparison& c) {
    const std::string items = list("gone", faces_gone(c)) + list("new", faces_new(c)) +
                              list("turned inside out", faces_turned(c));
    return items.empty() ? "" : "<ul>" + items + "</ul>";
}

std::string footer(const Comparison& c) {
    return "<footer><p>Distances are those to the nearest point of the exact trimmed surface, at " +
           std::to_string(c.deviation.samples) + " and " + std::to_string(c.missing.samples) +
           " places. Criteria <b>" + html_escaped(c.inspection_after.preset.name) + "</b>." +
           (c.rig.empty() ? "" : " Lamps: " + html_escaped(c.rig) + ", the same for both.") +
           "</p><p>Keiko " + html_escaped(c.tool_version) + "</p></footer>\n";
}

} // namespace

std::string comparison_html(const Comparison& c) {
    std::string html = head(c);
    html += html_section("Scope and zones", scope(c));
    html += html_section("Checks", html_checks(c));
    html += html_section("Alignment", alignment(c));
    html += html_section("Deviation", maps(c) + html_percentiles(c));
    html += html_section("Worst places", html_worst_places(c));
    html += html_section("Faces", faces(c));
    for (const ComparedView& view : c.views) html += view_section(c, view);
    html += html_section("Seams", html_seam_changes(c));
    html += html_section("Findings", html_finding_changes(c));
    return html_page("comparison", std::string(slider_style) + std::string(maps_style),
                     html + footer(c));
}

} // namespace keiko
