#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {

std::string html_scope(const Report& report) {
    const Inspection& inspection = report.inspection;
    const auto sentences = scope_sentences(inspection.scope, inspection.preset);
    if (sentences.empty()) return "";
    std::string html = "<section><h2>Scope and zones</h2><div class=\"card\"><ul>";
    for (const std::string& sentence : sentences) html += "<li>" + html_escaped(sentence) + "</li>";
    return html + "</ul></div></section>\n";
}

} // namespace keiko
