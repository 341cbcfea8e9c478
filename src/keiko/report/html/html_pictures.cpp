#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

std::string marker(const PictureMarker& m, const ReportPicture& picture) {
    return "<span class=\"marker\" style=\"left:" + fixed_number(100 * m.x / picture.width, 2) +
           "%;top:" + fixed_number(100 * m.y / picture.height, 2) + "%\">" +
           std::to_string(m.number) + "</span>";
}

/// The close-up of a finding nearest to a place; null without any.
const CloseUp* found(const Report& report, CloseUp::Of of, std::size_t index,
                     const Vec3& place = Vec3(0)) {
    const CloseUp* nearest = nullptr;
    for (const CloseUp& one : report.close_ups)
        if (one.of == of && one.index == index &&
            (!nearest || (one.place - place).length2() < (nearest->place - place).length2()))
            nearest = &one;
    return nearest;
}

std::string image(const CloseUp& close_up) {
    return "<img id=\"" + html_escaped(close_up.picture.title) +
           "\" class=\"shot\" alt=\"close-up\" src=\"data:image/png;base64," +
           base64(close_up.picture.png) + "\">";
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

std::string html_figures(std::span<const ReportPicture> pictures) {
    if (pictures.empty()) return "";
    std::string html = "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : pictures) html += html_figure(picture);
    return html + "</div>\n";
}

std::string html_pictures(const Report& report) {
    return html_section("Reflections", html_drawing(report) + html_figures(report.pictures));
}

std::string html_form(const Report& report) {
    if (report.curvature_pictures.empty()) return "";
    std::string html =
        "<section><h2>Form</h2><p class=\"soft\">Gaussian curvature, blue where the face is a "
        "saddle; black are the inflection curves, along which it changes its sign. Zebra: rings "
        "about the vertical, mirrored; they run smoothly where the curvature does.</p>";
    return html + html_figures(report.curvature_pictures) + "</section>\n";
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

std::string html_close_up(const Report& report, CloseUp::Of of, std::size_t index,
                          const Vec3& place) {
    const CloseUp* close_up = found(report, of, index, place);
    return close_up ? image(*close_up) : "";
}

std::string html_opens_close_up(const Report& report, CloseUp::Of of, std::size_t index) {
    const CloseUp* close_up = found(report, of, index);
    if (!close_up) return "";
    return " data-shot=\"" + html_escaped(close_up->picture.title) +
           "\" tabindex=\"0\" title=\"show a close-up\"";
}

std::string html_gallery(const Report& report) {
    if (report.close_ups.empty()) return "";
    const std::vector<ShownItem> shown = shown_items(report);
    const auto shows = [](const CloseUp& close_up, const ShownItem& item) {
        return close_up.of == CloseUp::Of::seam
                   ? item.seam == close_up.index
                   : close_up.of == CloseUp::Of::face && item.face == close_up.index;
    };
    std::string html = "<div hidden>\n";
    for (const CloseUp& close_up : report.close_ups)
        if (std::none_of(shown.begin(), shown.end(),
                         [&](const ShownItem& item) { return shows(close_up, item); }))
            html += image(close_up) + "\n";
    return html +
           "</div>\n<dialog id=\"viewer\"><img alt=\"close-up\"><p></p>"
           "<form method=\"dialog\"><button>Close</button></form></dialog>\n";
}

} // namespace keiko
