#include "keiko/report/content/report.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

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
           "Lengths in mm, places in the coordinates of the model.</p><p>Keiko " +
           html_escaped(report.tool_version) + "</p></footer>";
}

} // namespace

std::string report_html(const Report& report) {
    std::string html;
    for (const auto section :
         {html_verdict, html_pictures, html_worst_seams, html_looks, html_coverage, html_lines,
          html_form, html_combs, html_all_seams, html_faces, html_facts, html_gallery})
        html += section(report);
    html += footer(report) + "\n";
    return html_page(html_escaped(report.inspection.facts.source), "", html, report_script);
}

FolderContent report_files(const Report& report) {
    FolderContent files;
    for (const auto* pictures :
         {&report.pictures, &report.line_pictures, &report.curvature_pictures})
        for (const ReportPicture& picture : *pictures) files[picture.file_name] = picture.png;
    for (const CloseUp& close_up : report.close_ups)
        files[close_up.picture.file_name] = close_up.picture.png;
    for (const CombPicture& picture : report.combs) files[picture.file_name()] = picture.svg;
    files["report.json"] = report_json(report);
    files["report.html"] = report_html(report);
    return files;
}

} // namespace keiko
