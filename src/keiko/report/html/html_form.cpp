#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {

std::string html_form(const Report& report) {
    if (report.curvature_pictures.empty()) return "";
    std::string html =
        "<section><h2>Form</h2><p class=\"soft\">Gaussian curvature, blue where the face is a "
        "saddle; black are the inflection curves, along which it changes its sign. Zebra: rings "
        "about the vertical, mirrored; they run smoothly where the curvature does.</p>"
        "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : report.curvature_pictures) html += html_figure(picture);
    return html + "</div></section>\n";
}

std::string html_combs(const Report& report) {
    if (report.combs.empty() && report.comb_remarks.empty()) return "";
    std::string html = "<section><h2>Curvature combs</h2>\n";
    for (const std::string& remark : report.comb_remarks)
        html += "<p class=\"soft\">" + html_escaped(remark) + ".</p>\n";
    for (const CombPicture& picture : report.combs)
        html += "<figure class=\"card combs\">" + picture.svg + "</figure>\n";
    return html + "</section>\n";
}

} // namespace keiko
