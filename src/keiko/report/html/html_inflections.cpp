#include "keiko/report/html/html_inflections.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_table.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

/// Number of rows beyond which places are left to keiko lines.
constexpr std::size_t most_rows = 1000;

std::string row(std::size_t rank, const std::string& view, const JoinedLine& line,
                const LineInflection& turn) {
    const std::string number = std::to_string(rank), of_view = html_escaped(view);
    const std::string lamp = std::to_string(line.plane) + "." + std::to_string(line.lamp);
    return "<tr>" + html_cell(number, number) + html_cell(of_view, of_view, "left") +
           html_cell(lamp, lamp) +
           html_number_cell(line.length, fixed_number(line.length, 1), false) +
           html_number_cell(turn.along, fixed_number(turn.along, 1), false) +
           html_cell(short_number(turn.place.x, 9), place_text(turn.place)) + "</tr>\n";
}

} // namespace

std::string html_inflections(const LineList& list) {
    std::string rows;
    std::size_t count = 0, lines = 0;
    for (const ViewLines& view : list.views)
        for (const JoinedLine& line : view.found.lines) {
            if (!line.inflections.empty()) ++lines;
            for (const LineInflection& turn : line.inflections)
                if (++count <= most_rows) rows += row(count, view.view, line, turn);
        }
    if (count == 0) return "";
    std::string html =
        "<details><summary>" + counted(lines, "line") +
        (lines == 1 ? " turns over at " : " turn over at ") + counted(count, "place") +
        "</summary>" +
        html_table_head({"#", "view", "lamp", "line mm long", "along it mm", "place x, y, z"},
                        "view") +
        rows + std::string(html_table_end);
    if (count > most_rows)
        html += "<p class=\"soft\">and " + std::to_string(count - most_rows) +
                " more; the table of inflections of keiko lines has them all.</p>";
    return html + "</details>\n";
}

} // namespace keiko
