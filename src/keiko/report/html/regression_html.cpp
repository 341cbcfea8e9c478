#include "keiko/base/text.h"
#include "keiko/report/content/regression.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"

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
                       counted(regression.fixtures.size(), "fixture") + "</h1>";
    if (regression.shards > 1)
        html += "<div class=\"soft\">shard " + std::to_string(regression.shard) + " of " +
                std::to_string(regression.shards) + "</div>";
    html += "</div></header>\n<div class=\"counts\">";
    for (const FixtureState state : every_fixture_state) html += count(regression, state);
    return html + "</div>\n";
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
    return "<tr>" + html_text_cell(d.check, true) + html_text_cell(d.name, true) +
           html_text_cell(value_text(d.before)) + html_text_cell(value_text(d.after)) +
           html_text_cell(change) + html_text_cell(change.empty() ? "" : short_number(d.allowed)) +
           html_text_cell(std::string(unit_of(d.quantity))) + "</tr>";
}

std::string metrics_table(const FixtureOutcome& fixture) {
    if (fixture.metrics.empty()) return "";
    std::string rows;
    for (const MetricDifference& metric : fixture.metrics) rows += metric_row(metric);
    return html_plain_table({"<check", "<metric", "before", "after", "change", "allowed", "unit"},
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
    if (!picture.layers.empty()) html += html_layers(picture);
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
        html +=
            "<p>There is no baseline. Inspect the candidate, then accept it by the name <code>" +
            html_escaped(fixture.name) + "</code>.</p>";
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

std::string stale_section(const Regression& regression) {
    std::string names;
    for (const std::string& name : regression.stale_baselines)
        names += (names.empty() ? "" : ", ") + html_escaped(name);
    return names.empty()
               ? ""
               : "<section><h2>Stale baselines</h2><p>No fixture has the name of: " + names +
                     "</p></section>\n";
}

} // namespace

std::string regression_html(const Regression& regression) {
    std::string html = head(regression);
    for (const FixtureOutcome& fixture : regression.fixtures) html += fixture_section(fixture);
    html += same_section(regression) + stale_section(regression) + "<footer><p>Keiko " +
            html_escaped(regression.tool_version) + "</p></footer>\n";
    return html_page("regression", slider_style, html);
}

} // namespace keiko
