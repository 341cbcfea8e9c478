#include "keiko/report/content/comparison.h"
#include "keiko/report/content/scan_comparison.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <numeric>

namespace keiko {
namespace {

constexpr std::string_view histogram_style = R"css(
.histogram { display: block; width: 100%; height: auto; margin-bottom: 16px; }
.histogram text { font-size: 11px; fill: var(--soft); }
.histogram .axis { stroke: var(--line); } .histogram .limit { stroke: var(--fail); stroke-dasharray: 4 3; }
.histogram .in { fill: var(--soft); } .histogram .out { fill: var(--fail); }
)css";

std::string tone_of(const ScanComparison& c) {
    const auto passes = c.passes();
    if (!passes) return "undecided";
    return *passes ? "pass" : "fail";
}

std::string head(const ScanComparison& c) {
    return "<header class=\"card head " + tone_of(c) + "\"><div class=\"verdict\">" +
           verdict_of(c) + "</div><div class=\"names\"><h1>" + html_escaped(c.scan) +
           "</h1><div class=\"soft\">measured on " + html_escaped(c.nominal) +
           "</div><div class=\"soft\">" + html_escaped(verdict_reason(c)) +
           "</div></div></header>\n";
}

std::string maps(const ScanComparison& c) {
    const std::string caption = "deviation of the points from the nominal, their mean within " +
                                short_number(c.map_radius) +
                                " mm: red outside, blue inside; dark: no points";
    std::vector<DeviationMapFigure> figures;
    for (const ScanView& view : c.views) {
        const auto found = c.pngs.find(view.map);
        if (found != c.pngs.end())
            figures.push_back({view.name, found->second, view.width, view.height});
    }
    return html_maps(figures, caption);
}

std::string numbers(const std::vector<double>& values) {
    std::string cells;
    for (const double value : values) cells += html_text_cell(short_number(value));
    return cells;
}

std::string statistics(const ScanDeviation& d) {
    if (d.measured == 0) return "";
    return html_plain_table(
        {"mean, mm", "rms, mm", "standard deviation, mm", "half within, mm", "90 %", "99 %",
         "99.9 %", "lowest, mm", "highest, mm"},
        "<tr>" +
            numbers({d.mean, d.root_mean_square, d.standard_deviation, d.median, d.percent_90,
                     d.percent_99, d.percent_99_9, d.lowest.value, d.highest.value}) +
            "</tr>");
}

std::string counts(const ScanComparison& c) {
    const ScanDeviation& d = c.deviation;
    std::string cells;
    for (const std::size_t count : {d.points, d.measured, d.beyond, d.beside, d.uncertain})
        cells += html_text_cell(std::to_string(count));
    return html_plain_table({"points", "measured", "farther than " + short_number(c.reach) + " mm",
                             "beyond free borders", "not proved"},
                            "<tr>" + cells + "</tr>");
}

/// The faces with points, those of the largest root mean square first.
std::string faces(const ScanComparison& c) {
    std::vector<std::size_t> order(c.faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t f) { return c.deviation.faces[f].points == 0; });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return c.deviation.faces[a].root_mean_square > c.deviation.faces[b].root_mean_square;
    });
    std::string rows;
    for (const std::size_t f : order) {
        const ScannedFace& face = c.deviation.faces[f];
        const double within =
            100 * static_cast<double>(face.within) / static_cast<double>(face.points);
        rows += "<tr>" + html_text_cell(c.faces[f], true) +
                html_text_cell(std::to_string(face.points)) +
                numbers({face.mean, face.root_mean_square, face.lowest, face.highest}) +
                (c.limits.tolerance ? html_text_cell(short_number(within)) : "") + "</tr>";
    }
    if (rows.empty()) return "";
    std::vector<std::string> headings{"<face",   "points",     "mean, mm",
                                      "rms, mm", "lowest, mm", "highest, mm"};
    if (c.limits.tolerance) headings.emplace_back("within, %");
    return html_plain_table(headings, rows);
}

std::string place(const ScanComparison& c, const std::string& word, const DeviationPlace& at) {
    return "<tr>" + html_text_cell(word, true) + html_text_cell(short_number(at.value)) +
           html_text_cell(place_text(at.place)) + html_text_cell(c.faces[at.face], true) + "</tr>";
}

std::string worst_places(const ScanComparison& c) {
    if (c.deviation.measured == 0) return "";
    return html_plain_table(
        {"", "mm", "at, mm", "<face"},
        place(c, "lowest", c.deviation.lowest) + place(c, "highest", c.deviation.highest));
}

std::string alignment(const ScanComparison& c) {
    if (!c.alignment) return "<p>The points were not moved.</p>";
    return "<p>The points were " + html_escaped(alignment_words(c.alignment->rigid)) +
           ".</p><p>By " + html_escaped(fit_words(*c.alignment)) + ".</p>";
}

} // namespace

std::string scan_html(const ScanComparison& c) {
    std::string html = head(c);
    html += html_section("Deviation", maps(c) + histogram_svg(c) + statistics(c.deviation));
    html += html_section("Worst places", worst_places(c));
    html += html_section("Points", counts(c));
    html += html_section("Alignment", alignment(c));
    html += html_section("Faces", faces(c));
    html +=
        "<footer><p>Distances are those to the nearest point of the exact trimmed surface.</p>"
        "<p>Keiko " +
        html_escaped(c.tool_version) + "</p></footer>\n";
    return html_page("scan", std::string(maps_style) + std::string(histogram_style), html);
}

} // namespace keiko
