#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {

const std::string_view drawing_style = R"css(
.drawn { padding: 8px 8px 0; margin-bottom: 16px; } .drawing { display: block; width: 100%; height: auto; }
.drawing path { fill: none; stroke: var(--ink); stroke-width: 1; stroke-linecap: round; stroke-linejoin: round; }
.drawing .outlines { stroke-width: 1.6; } .drawing .seams { stroke: var(--soft); stroke-width: 0.5; }
.drawing path.hidden { stroke: var(--soft); stroke-width: 0.5; stroke-dasharray: 4 3; }
.drawing text { fill: var(--soft); font-size: 13px; text-anchor: middle; }
.mark rect { fill: var(--card); stroke: var(--tone); stroke-width: 1.5; }
.mark text { fill: var(--tone); font-size: 12px; font-weight: 700; }
.mark.hidden rect { stroke-dasharray: 3 2; } .mark:hover rect { fill: var(--tint); }
tr:target td { background: var(--tint); }
)css";

std::string html_drawing(const Report& report) {
    if (report.drawing.empty()) return "";
    if (!report.drawing.starts_with("<svg"))
        return "<p class=\"soft small\">" + html_escaped(report.drawing) + "</p>\n";
    const bool marked = !whole_inspection(report).findings.empty();
    std::string caption = "Outlines, edges and seams of the exact surface, hidden ones dashed.";
    if (marked)
        caption +=
            " Numbers are those of the table of findings; a dashed ring is at a place that "
            "the view hides.";
    return "<figure class=\"card drawn\">" + report.drawing + "<figcaption class=\"soft small\">" +
           caption + "</figcaption></figure>\n";
}

} // namespace keiko
