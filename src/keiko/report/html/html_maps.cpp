#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

std::string figure(const DeviationMapFigure& map, const std::string& caption) {
    return "<figure class=\"card\"><div class=\"picture\"><img alt=\"signed distance map, " +
           html_escaped(map.view) + "\" width=\"" + std::to_string(map.width) + "\" height=\"" +
           std::to_string(map.height) + "\" src=\"data:image/png;base64," + base64(map.png) +
           "\"></div><figcaption><b>" + html_escaped(map.view) +
           "</b><br><span class=\"soft small\">" + html_escaped(caption) +
           "</span></figcaption></figure>\n";
}

} // namespace

const std::string_view maps_style = R"css(
.maps { display: grid; grid-template-columns: repeat(auto-fit, minmax(480px, 1fr)); gap: 16px;
  margin-bottom: 16px; }
.card.scroll + p { margin-top: 16px; }
)css";

std::string html_section(const std::string& title, const std::string& content) {
    if (content.empty()) return "";
    return "<section><h2>" + title + "</h2>" + content + "</section>\n";
}

std::string html_maps(std::span<const DeviationMapFigure> maps, const std::string& caption) {
    std::string html;
    for (const DeviationMapFigure& map : maps) html += figure(map, caption);
    return html.empty() ? "" : "<div class=\"maps\">" + html + "</div>\n";
}

} // namespace keiko
