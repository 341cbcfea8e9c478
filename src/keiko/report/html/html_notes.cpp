#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

/// Place of a note, "face 2 (dome) at 1.0, 2.0, 3.0 mm".
std::string place_of(const AnalysisNote& note, const std::vector<MeasuredFace>& faces) {
    const std::string at = place_text(note.place) + " mm";
    if (note.face == 0) return "no place on this body any more; it was at " + at;
    const auto own = std::find_if(faces.begin(), faces.end(),
                                  [&](const MeasuredFace& face) { return face.id == note.face; });
    const std::string name = own != faces.end() ? own->name : "face " + std::to_string(note.face);
    return name + " at " + at;
}

} // namespace

std::string html_notes(const Report& report) {
    if (report.notes.empty()) return "";
    std::string html = "<div class=\"card\"><ul>";
    for (const AnalysisNote& note : report.notes)
        html += "<li>" + html_escaped(note.text) + " <span class=\"soft\">" +
                html_escaped(place_of(note, report.inspection.faces)) + "</span></li>";
    return html_section("Notes", html + "</ul></div>");
}

} // namespace keiko
