#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

const CloseUp* found(const Report& report, CloseUp::Of of, std::size_t index) {
    const auto close_up =
        std::find_if(report.close_ups.begin(), report.close_ups.end(),
                     [&](const CloseUp& one) { return one.of == of && one.index == index; });
    return close_up == report.close_ups.end() ? nullptr : &*close_up;
}

std::string image(const CloseUp& close_up) {
    return "<img id=\"" + html_escaped(close_up.picture.title) +
           "\" class=\"shot\" alt=\"close-up\" src=\"data:image/png;base64," +
           base64(close_up.picture.png) + "\">";
}

} // namespace

std::string html_close_up(const Report& report, CloseUp::Of of, std::size_t index) {
    const CloseUp* close_up = found(report, of, index);
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
    const std::vector<std::uint32_t> shown = worst_seams(report.inspection, worst_seam_count);
    std::string html = "<div hidden>\n";
    for (const CloseUp& close_up : report.close_ups)
        if (close_up.of != CloseUp::Of::seam ||
            std::find(shown.begin(), shown.end(), close_up.index) == shown.end())
            html += image(close_up) + "\n";
    return html +
           "</div>\n<dialog id=\"viewer\"><img alt=\"close-up\"><p></p>"
           "<form method=\"dialog\"><button>Close</button></form></dialog>\n";
}

} // namespace keiko
