#include "keiko/base/text.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/report.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

/// The section that a number of the head leads to, and a word on the thing counted.
struct Target {
    std::string_view section, meaning = {};
};
constexpr Target of_seams{"seams",
                          "A stretch is a part of a seam: smooth, a crease, or a run-out."};
constexpr Target of_run_outs{"seams",
                             "A run-out is the end of a crease that fades into the surface."};
constexpr Target of_scraps{"scraps", "A scrap is a stretch too short to be a finding by itself."};
constexpr Target of_lines{"lines", "Reflections of lamps that break where they cross a seam."};
constexpr Target of_accepted{"accepted"}, of_coverage{"coverage"}, of_faces{"faces"},
    of_file{"file"};

std::string count(std::string_view tone, const std::string& number, bool none,
                  std::string_view label, const Target& target) {
    return "<a class=\"card count " + std::string(tone) + (none ? " none" : "") + "\" href=\"#" +
           std::string(target.section) + "\" title=\"" + std::string(target.meaning) + "\"><b>" +
           number + "</b>" + std::string(label) + "</a>";
}

std::string count(std::string_view tone, std::size_t number, std::string_view label,
                  const Target& target) {
    return count(tone, std::to_string(number), number == 0, label, target);
}

std::string count(std::string_view tone, std::size_t number, std::string_view one,
                  std::string_view several, const Target& target) {
    return count(tone, number, number == 1 ? one : several, target);
}

std::string percent(double share, int decimals = 1) {
    return fixed_number(share * 100, decimals) + " %";
}

/// "class-a-outer: gap 0.01 mm, angle 0.1°, curvature 10 %, its slope 0.1°"
std::string criteria_line(const Inspection& inspection) {
    const CriteriaPreset& preset = inspection.preset;
    std::string text = html_escaped(preset.name) + ": gap " + short_number(preset.gap) +
                       " mm, angle " + short_number(preset.angle) + "°";
    if (preset.curvature)
        text += ", curvature " + short_number(preset.curvature->limit * 100) + " %";
    if (preset.curvature_slope)
        text += ", its slope " + short_number(*preset.curvature_slope) + "°";
    return text;
}

/// "2 faces, 0 seams · 798.8 of 798.8 mm of borders meet no other · class-a-outer: ..."
std::string body_line(const Inspection& inspection) {
    const std::string unmet = unmet_borders(inspection.facts);
    const std::string part = scope_words(inspection.scope);
    return counted(inspection.facts.placed_faces, "face") + ", " +
           counted(inspection.facts.seams, "seam") +
           (unmet.empty() ? "" : " · " + html_escaped(unmet)) + " · " +
           (part.empty() ? "" : "<b>" + html_escaped(part) + "</b> · ") + criteria_line(inspection);
}

std::string footer(const Report& report) {
    const CriteriaPreset& preset = report.inspection.preset;
    return "<footer><p>Criteria <b>" + html_escaped(preset.name) +
           "</b>: " + html_escaped(preset.source) +
           ".</p><p>Gap: distance between the trimmed borders of the "
           "two faces. Angle: between their normals; it moves "
           "the image of a lamp 2 m away by the length beside it. Curvature: across the seam, "
           "judged where gap "
           "and angle pass. Its slope: angle between the plots of the radius of curvature on the "
           "two sides, judged where the curvature passes. Knot lines are those inside a face at "
           "which it breaks. Seams above " +
           short_number(preset.feature_angle) +
           "° are creases: listed, no findings. Lines: where the eye sees the axis of a lamp; jump "
           "across the line on the part, turn the seam angle that moves the lamp's image as far, "
           "kink its angle and bend the change of its curvature. Undecided: the error bound "
           "straddles the limit. Faces: curvature is positive where a face bends towards its "
           "outward "
           "normal; \"to\" tells how far beyond the value found the extreme may lie. "
           "Lengths in mm, places in the coordinates of the model.</p><p>To turn the body, drag "
           "the "
           "lamps and fly to the faults: <code>keiko view FOLDER</code>, the folder of this "
           "file.</p><p>Keiko " +
           html_escaped(report.tool_version) + "</p></footer>";
}

} // namespace

std::string html_verdict(const Report& report) {
    const Inspection& inspection = report.inspection;
    const SeamCounts& counts = inspection.counts;
    const std::string verdict(name_of(verdict_of(report)));
    std::string html = "<header class=\"card head " + verdict + "\"><div class=\"verdict\">" +
                       verdict + "</div><div class=\"names\"><h1>" +
                       html_escaped(inspection.facts.source) + "</h1><div class=\"soft\">" +
                       body_line(inspection) + "</div>";
    if (const std::string warning = nothing_judged(inspection); !warning.empty())
        html += "<div><b>" + warning + "</b></div>";
    html += "</div></header>\n";
    html += "<div class=\"counts\">" +
            count("fail", counts.fail, "stretch fails", "stretches fail", of_seams) +
            count("undecided", counts.undecided, "undecided", of_seams) +
            count("pass", counts.pass, "pass", of_seams) +
            count("crease", counts.creases, "crease", "creases", of_seams);
    if (counts.run_outs > 0)
        html += count("crease", counts.run_outs, "run-out", "run-outs", of_run_outs);
    if (counts.scraps > 0) html += count("crease", counts.scraps, "scrap", "scraps", of_scraps);
    if (counts.accepted > 0)
        html +=
            count("crease", counts.accepted, "stretch accepted", "stretches accepted", of_accepted);
    if (report.lines)
        html += count("fail", count_crossings(*report.lines).fail, "line crossing fails",
                      "line crossings fail", of_lines);
    if (report.coverage)
        html += count("open", percent(1 - report.coverage->covered), report.coverage->covered >= 1,
                      "not covered", of_coverage);
    if (judges_faces(inspection.preset))
        html += count("fail", inspection.face_counts.fail, "faces fail", of_faces) +
                count("undecided", inspection.face_counts.undecided, "faces undecided", of_faces);
    if (inspection.face_counts.accepted > 0)
        html += count("crease", inspection.face_counts.accepted, "face accepted", "faces accepted",
                      of_accepted);
    if (!inspection.facts.lost_faces.empty())
        html +=
            count("fail", inspection.facts.lost_faces.size(), "face lost", "faces lost", of_file);
    return html + "</div>\n";
}

std::string html_coverage(const Report& report) {
    if (!report.coverage) return "";
    const CoverageSummary& coverage = *report.coverage;
    const double share = std::clamp(coverage.covered, 0.0, 1.0);
    std::string html =
        "<section id=\"coverage\"><h2>Coverage</h2><div class=\"card coverage\"><b>" +
        percent(share) + "</b> of the surface in view mirrors the lamps of " +
        html_escaped(coverage.rig) + html_bar(share);
    if (share >= 1)
        html += "<div class=\"soft\">Nothing was left out.</div>";
    else if (coverage.unreached.empty())
        html += "<div class=\"soft\">The other " + percent(1 - share) +
                " are on faces of which more than half is reached, or of less than 0.5 % of the "
                "pictures.</div>";
    else
        html += "<p class=\"soft\">Not reached, so not judged by reflections:</p><ul>";
    for (const std::string& name : coverage.unreached)
        html += "<li>" + html_escaped(name) + "</li>";
    if (!coverage.unreached.empty()) html += "</ul>";
    return html + "</div></section>\n";
}

std::string report_html(const Report& report) {
    std::string html;
    for (const auto section :
         {html_verdict,   html_scope,  html_first_screen, html_more_faults, html_pictures,
          html_hidden,    html_notes,  html_findings,     html_accepted,    html_looks,
          html_coverage,  html_lines,  html_form,         html_combs,       html_more_profiles,
          html_all_seams, html_scraps, html_joints,       html_faces,       html_facts,
          html_gallery})
        html += section(report);
    html += footer(report) + "\n";
    return html_page(html_escaped(report.inspection.facts.source), drawing_style, html,
                     report_script);
}

FolderContent report_files(const Report& report) {
    FolderContent files;
    for (const auto* pictures : {&report.standing_pictures, &report.pictures, &report.line_pictures,
                                 &report.curvature_pictures})
        for (const ReportPicture& picture : *pictures) files[picture.file_name] = picture.png;
    for (const CloseUp& close_up : report.close_ups)
        files[close_up.picture.file_name] = close_up.picture.png;
    for (const CombPicture& picture : report.combs) files[picture.file_name()] = picture.svg;
    files["report.json"] = report_json(report);
    files["report.html"] = report_html(report);
    return files;
}

} // namespace keiko
