#include "keiko/base/text.h"
#include "keiko/report/content/unmet_borders.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

std::string count(std::string_view tone, const std::string& number, bool none,
                  std::string_view label) {
    return "<div class=\"card count " + std::string(tone) + (none ? " none" : "") + "\"><b>" +
           number + "</b>" + std::string(label) + "</div>";
}

std::string count(std::string_view tone, std::size_t number, std::string_view label) {
    return count(tone, std::to_string(number), number == 0, label);
}

std::string count(std::string_view tone, std::size_t number, std::string_view one,
                  std::string_view several) {
    return count(tone, number, number == 1 ? one : several);
}

std::string percent(double share, int decimals = 1) {
    return fixed_number(share * 100, decimals) + " %";
}

std::string marker(const PictureMarker& m, const ReportPicture& picture) {
    return "<span class=\"marker\" style=\"left:" + fixed_number(100 * m.x / picture.width, 2) +
           "%;top:" + fixed_number(100 * m.y / picture.height, 2) + "%\">" +
           std::to_string(m.number) + "</span>";
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
    return counted(inspection.facts.placed_faces, "face") + ", " +
           counted(inspection.facts.seams, "seam") +
           (unmet.empty() ? "" : " · " + html_escaped(unmet)) + " · " + criteria_line(inspection);
}

} // namespace

std::string html_figure(const ReportPicture& picture) {
    std::string html = "<figure class=\"card\"><div class=\"picture\"><img alt=\"" +
                       html_escaped(picture.title) + "\" width=\"" + std::to_string(picture.width) +
                       "\" height=\"" + std::to_string(picture.height) +
                       "\" src=\"data:image/png;base64," + base64(picture.png) + "\">";
    for (const PictureMarker& m : picture.markers) html += marker(m, picture);
    html += "</div><figcaption><b>" + html_escaped(picture.title) + "</b>";
    if (!picture.caption.empty())
        html += "<br><span class=\"soft small\">" + html_escaped(picture.caption) + "</span>";
    return html + "</figcaption></figure>\n";
}

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
            count("fail", counts.fail, "stretch fails", "stretches fail") +
            count("undecided", counts.undecided, "undecided") + count("pass", counts.pass, "pass") +
            count("crease", counts.creases, "crease", "creases");
    if (counts.run_outs > 0) html += count("crease", counts.run_outs, "run-out", "run-outs");
    if (counts.scraps > 0) html += count("crease", counts.scraps, "scrap", "scraps");
    if (report.lines)
        html += count("fail", count_crossings(*report.lines).fail, "line crossing fails",
                      "line crossings fail");
    if (report.coverage)
        html += count("open", percent(1 - report.coverage->covered), report.coverage->covered >= 1,
                      "not covered");
    if (inspection.preset.surface != SurfaceLimits{})
        html += count("fail", inspection.face_counts.fail, "faces fail") +
                count("undecided", inspection.face_counts.undecided, "faces undecided");
    if (!inspection.facts.lost_faces.empty())
        html += count("fail", inspection.facts.lost_faces.size(), "face lost", "faces lost");
    return html + "</div>\n";
}

std::string html_pictures(const Report& report) {
    if (report.pictures.empty()) return "";
    std::string html = "<section><h2>Reflections</h2><div class=\"pictures\">\n";
    for (const ReportPicture& picture : report.pictures) html += html_figure(picture);
    return html + "</div></section>\n";
}

std::string html_coverage(const Report& report) {
    if (!report.coverage) return "";
    const CoverageSummary& coverage = *report.coverage;
    const double share = std::clamp(coverage.covered, 0.0, 1.0);
    std::string html = "<section><h2>Coverage</h2><div class=\"card coverage\"><b>" +
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

} // namespace keiko
