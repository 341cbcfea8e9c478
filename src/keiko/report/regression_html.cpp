#include "keiko/report/html_text.h"
#include "keiko/report/picture_slider.h"
#include "keiko/report/regression.h"
#include "keiko/report/report_style.h"

namespace keiko {
namespace {

std::string tone_of(FixtureState state) {
    if (state == FixtureState::same) return "pass";
    return state == FixtureState::missing ? "undecided" : "fail";
}

std::string count(const Regression& regression, FixtureState state) {
    const std::size_t number = regression.count(state);
    return "<div class=\"card count " + tone_of(state) + (number == 0 ? " none" : "") + "\"><b>" +
           std::to_string(number) + "</b>" + std::string(name_of(state)) + "</div>";
}

std::string head(const Regression& regression) {
    const std::string verdict(name_of(regression.state()));
    std::string html = "<header class=\"card head " + tone_of(regression.state()) +
                       "\"><div class=\"verdict\">" + verdict +
                       "</div><div class=\"names\"><h1>Regression of " +
                       std::to_string(regression.fixtures.size()) + " fixtures</h1>";
    if (regression.shards > 1)
        html += "<div class=\"soft\">shard " + std::to_string(regression.shard) + " of " +
                std::to_string(regression.shards) + "</div>";
    html += "</div></header>\n<div class=\"counts\">";
    for (const FixtureState state : every_fixture_state) html += count(regression, state);
    return html + "</div>\n";
}

std::string table(const std::string& header, const std::string& rows) {
    return "<div class=\"card scroll\"><table><thead><tr>" + header + "</tr></thead><tbody>" +
           rows + "</tbody></table></div>\n";
}

std::string cell(const std::string& text, bool left = false) {
    return std::string(left ? "<td class=\"left\">" : "<td>") + html_escaped(text) + "</td>";
}

std::string value_text(const std::optional<std::variant<double, std::string>>& value) {
    if (!value) return "–";
    const double* real = std::get_if<double>(&*value);
    return real ? short_number(*real, 9) : std::get<std::string>(*value);
}

std::string metric_row(const MetricDifference& d) {
    std::string change;
    const double* before = d.before ? std::get_if<double>(&*d.before) : nullptr;
    const double* after = d.after ? std::get_if<double>(&*d.after) : nullptr;
    if (before && after) change = short_number(*after - *before);
    return "<tr>" + cell(d.check, true) + cell(d.name, true) + cell(value_text(d.before)) +
           cell(value_text(d.after)) + cell(change) +
           cell(change.empty() ? "" : short_number(d.allowed)) +
           cell(std::string(unit_of(d.quantity))) + "</tr>";
}

std::string metrics_table(const FixtureOutcome& fixture) {
    if (fixture.metrics.empty()) return "";
    std::string rows;
    for (const MetricDifference& metric : fixture.metrics) rows += metric_row(metric);
    return table(
        "<th class=\"left\">check</th><th class=\"left\">metric</th><th>before</th>"
        "<th>after</th><th>change</th><th>allowed</th><th>unit</th>",
        rows);
}

std::string layer_row(const LayerDifference& layer) {
    const std::string tone = layer.within ? "pass" : "fail";
    return "<tr class=\"" + tone + "\">" + cell(layer.layer, true) + "<td class=\"tone\">" +
           (layer.within ? "within" : "beyond") + "</td>" + cell(std::to_string(layer.beyond)) +
           cell(short_number(layer.excess)) + cell(short_number(layer.largest)) +
           cell(short_number(layer.root_mean_square)) +
           cell(std::to_string(layer.x) + ", " + std::to_string(layer.y)) + "</tr>";
}

std::string layers_table(const PictureOutcome& picture) {
    std::string rows;
    for (const LayerDifference& layer : picture.layers) rows += layer_row(layer);
    return "<p class=\"small soft\">" + std::to_string(picture.pixels) + " pixels; " +
           std::to_string(picture.coverage_flips) + " where the outline moved, " +
           std::to_string(picture.face_flips) + " others with another face" +
           (picture.flips_within ? "" : ": too many") + "</p>" +
           table(
               "<th class=\"left\">layer</th><th></th><th>pixels beyond</th>"
               "<th>worst, in tolerances</th><th>largest difference</th>"
               "<th>root mean square</th><th>at pixel</th>",
               rows);
}

std::string_view png(const FixtureOutcome& fixture, const std::string& name) {
    const auto found = fixture.pngs.find(name);
    return found == fixture.pngs.end() ? std::string_view() : std::string_view(found->second);
}

std::string picture_section(const FixtureOutcome& fixture, const PictureOutcome& picture) {
    if (picture.within() && fixture.state != FixtureState::missing) return "";
    std::string html =
        "<p><b>" + html_escaped(picture.view) + "</b> " + html_escaped(picture.problem) + "</p>\n";
    html += html_slider({png(fixture, picture.before), png(fixture, picture.after),
                         png(fixture, picture.difference), picture.width, picture.height},
                        picture.view);
    if (!picture.layers.empty()) html += layers_table(picture);
    return html;
}

std::string fixture_section(const FixtureOutcome& fixture) {
    if (fixture.state == FixtureState::same) return "";
    std::string html = "<section id=\"" + html_escaped(fixture.name) + "\"><h2>" +
                       html_escaped(fixture.name) + " <span class=\"chip " +
                       tone_of(fixture.state) + "\">" + std::string(name_of(fixture.state)) +
                       "</span></h2>\n";
    if (!fixture.error.empty()) html += "<p>" + html_escaped(fixture.error) + "</p>";
    if (fixture.state == FixtureState::missing)
        html += "<p>There is no baseline. Look at the candidate; <code>--update " +
                html_escaped(fixture.name) + "</code> accepts it.</p>";
    html += metrics_table(fixture);
    for (const PictureOutcome& picture : fixture.pictures)
        html += picture_section(fixture, picture);
    return html + "</section>\n";
}

std::string same_section(const Regression& regression) {
    std::string names;
    for (const FixtureOutcome& fixture : regression.fixtures)
        if (fixture.state == FixtureState::same)
            names += (names.empty() ? "" : ", ") + html_escaped(fixture.name);
    return names.empty() ? "" : "<section><h2>Same</h2><p>" + names + "</p></section>\n";
}

} // namespace

std::string regression_html(const Regression& regression) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Keiko: regression</title>\n<style>";
    html += report_style;
    html += slider_style;
    html += "</style>\n</head>\n<body>\n<main>\n" + head(regression);
    for (const FixtureOutcome& fixture : regression.fixtures) html += fixture_section(fixture);
    return html + same_section(regression) + "<footer><p>Keiko " +
           html_escaped(regression.tool_version) + "</p></footer>\n</main>\n</body>\n</html>\n";
}

} // namespace keiko
