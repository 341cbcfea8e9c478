#include "keiko/base/text.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Number of rows beyond which passing crossings are left to report.json.
constexpr std::size_t most_crossings = 400;

std::string summary(const LineList& list) {
    const CrossingCounts counts = count_crossings(list);
    std::size_t lines = 0;
    for (const ViewLines& view : list.views) lines += view.found.lines.size();
    const std::string rig = list.rig.empty() ? "" : " of rig " + html_escaped(list.rig);
    return "<p class=\"soft\">" + counted(lines, "line") + " of the lamps" + rig +
           ", followed over the seams: " + counted(counts.fail, "crossing") +
           (counts.fail == 1 ? " fails, " : " fail, ") + std::to_string(counts.undecided) +
           " undecided, " + std::to_string(counts.pass) + " pass, " +
           std::to_string(counts.not_judged) + " not judged" +
           (counts.out_of_scope > 0 ? ", " + std::to_string(counts.out_of_scope) + " out of scope"
                                    : "") +
           ".</p>";
}

std::string value_cell(const LineValue& value, int decimals) {
    return html_number_cell(std::abs(value.value), fixed_number(std::abs(value.value), decimals),
                            value.limit && value.verdict != Verdict::pass);
}

std::string row(const Report& report, std::size_t rank, const CrossingPlace& place) {
    const LineCrossing& c = place.in(*report.lines);
    const std::string& view = report.lines->views[place.view].view;
    const std::string verdict(name_of(*c.verdict)), number = std::to_string(rank);
    const std::string lamp = std::to_string(c.plane) + "." + std::to_string(c.lamp);
    const std::string none = html_cell("", "–");
    std::string html = "<tr class=\"" + verdict + "\"" +
                       html_opens_close_up(report, CloseUp::Of::crossing, rank - 1) + ">" +
                       html_cell(number, number) + html_words_cell(c.faces) +
                       html_cell(html_escaped(view), html_escaped(view)) + html_cell(lamp, lamp) +
                       html_cell(number, "<span class=\"chip\">" + verdict + "</span>");
    html += value_cell(c.turn, 4);
    if (c.continued()) {
        html += value_cell(c.jump, 4) + value_cell(c.kink, 3);
        html += html_number_cell(std::abs(c.bend.value), short_number(std::abs(c.bend.value)),
                                 c.bend.limit && c.bend.verdict != Verdict::pass);
    } else {
        html += none + none + none;
    }
    return html + html_place_cell(c.place) + "</tr>\n";
}

/// The columns, with their limits if these are the same for all.
std::vector<std::string> headings(const CriteriaPreset& preset) {
    const LineLimits& limits = preset.lines;
    const auto with = [&](const std::string& name, const std::optional<double>& limit) {
        return limit ? with_limit(name, " ≤ " + short_number(*limit), preset) : name;
    };
    return {"#",
            "faces",
            "view",
            "lamp",
            "verdict",
            with("turn °", limits.turn),
            with("jump mm", limits.jump),
            with("kink °", limits.kink),
            with("bend 1/mm", limits.bend),
            "place x, y, z"};
}

std::string table(const Report& report) {
    const LineList& list = *report.lines;
    const std::vector<CrossingPlace> ranked = ranked_crossings(list);
    if (ranked.empty()) return "";
    const auto passing = std::find_if(
        ranked.begin(), ranked.end(),
        [&](const CrossingPlace& place) { return *place.in(list).verdict == Verdict::pass; });
    const std::size_t bad = static_cast<std::size_t>(passing - ranked.begin());
    const std::size_t shown = std::min(ranked.size(), std::max(bad, most_crossings));
    std::string html = html_table_head(headings(list.preset), {"faces"});
    for (std::size_t i = 0; i < shown; ++i) html += row(report, i + 1, ranked[i]);
    html += html_table_end;
    if (shown < ranked.size())
        html += "<p class=\"soft\">and " + std::to_string(ranked.size() - shown) +
                " more that pass; report.json has them all.</p>";
    return html;
}

/// Number of rows beyond which places are left to keiko lines.
constexpr std::size_t most_inflections = 1000;

std::string inflection_row(std::size_t rank, const std::string& view, const JoinedLine& line,
                           const LineInflection& turn) {
    const std::string number = std::to_string(rank), of_view = html_escaped(view);
    const std::string lamp = std::to_string(line.plane) + "." + std::to_string(line.lamp);
    return "<tr>" + html_cell(number, number) + html_cell(of_view, of_view, "left") +
           html_cell(lamp, lamp) +
           html_number_cell(line.length, fixed_number(line.length, 1), false) +
           html_number_cell(turn.along, fixed_number(turn.along, 1), false) +
           html_place_cell(turn.place) + "</tr>\n";
}

/// Inflections of the lines, in a table under a line that opens it; empty if there are none.
std::string inflections(const LineList& list) {
    std::string rows;
    std::size_t count = 0, lines = 0;
    for (const ViewLines& view : list.views)
        for (const JoinedLine& line : view.found.lines) {
            if (!line.inflections.empty()) ++lines;
            for (const LineInflection& turn : line.inflections)
                if (++count <= most_inflections)
                    rows += inflection_row(count, view.view, line, turn);
        }
    if (count == 0) return "";
    std::string html =
        "<details><summary>" + counted(lines, "line") +
        (lines == 1 ? " turns over at " : " turn over at ") + counted(count, "place") +
        "</summary>" +
        html_table_head({"#", "view", "lamp", "line mm long", "along it mm", "place x, y, z"},
                        {"view"}) +
        rows + std::string(html_table_end);
    if (count > most_inflections)
        html += "<p class=\"soft\">and " + std::to_string(count - most_inflections) +
                " more; the table of inflections of keiko lines has them all.</p>";
    return html + "</details>\n";
}

} // namespace

std::string html_lines(const Report& report) {
    if (!report.lines) return "";
    std::string html = "<section id=\"lines\"><h2>Reflection lines</h2>" + summary(*report.lines) +
                       "<div class=\"pictures\">\n";
    for (const ReportPicture& picture : report.line_pictures) html += html_figure(picture);
    return html + "</div>\n" + table(report) + inflections(*report.lines) + "</section>\n";
}

} // namespace keiko
