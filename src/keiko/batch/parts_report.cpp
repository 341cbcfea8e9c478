#include "keiko/batch/parts_report.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/report/markup/html_page.h"
#include "keiko/report/markup/html_text.h"
#include "keiko/report/markup/json_errors.h"
#include "keiko/report/markup/json_text.h"
#include "keiko/report/markup/junit_suites.h"

#include <algorithm>

namespace keiko {
namespace {

constexpr const char* format = "keiko-parts/1";

PartState state_from(const std::string& name) {
    for (const PartState state : every_part_state)
        if (name_of(state) == name) return state;
    throw Error("", in_quotes(name), "is no state of a part");
}

Json outcome_json(const PartOutcome& part) {
    return {{"name", part.name},
            {"file", part.file},
            {"state", name_of(part.state)},
            {"summary", part.summary},
            {"page", part.page}};
}

PartOutcome outcome_from(const Json& json) {
    return {json.at("name"), json.at("file"), state_from(json.at("state")), json.at("summary"),
            json.at("page")};
}

/// Throws Error for unsound values. Names of parts are names of folders.
void require_sound(const PartsRun& run) {
    if (run.shard < 1 || run.shard > run.shards)
        throw Error("", "shard", "is none of those there are");
    for (const std::string& name : run.all)
        if (name.empty() || name.starts_with('.') || name.find('/') != std::string::npos)
            throw Error("", in_quotes(name), "is no name of a part");
    for (const PartOutcome& part : run.parts)
        if (std::find(run.all.begin(), run.all.end(), part.name) == run.all.end())
            throw Error("", in_quotes(part.name), "is no part of the run");
}

PartsRun run_from(const Json& json) {
    if (json.at("format") != format) throw Error("", "format", std::string("is not ") + format);
    PartsRun run{.command = json.at("command"),
                 .tool_version = json.at("tool").at("version"),
                 .key = json.at("key"),
                 .shard = count_at<int>(json, "shard"),
                 .shards = count_at<int>(json, "shards"),
                 .all = json.at("all").get<std::vector<std::string>>()};
    for (const Json& part : json.at("parts")) run.parts.push_back(outcome_from(part));
    require_sound(run);
    return run;
}

/// Class of a state in the style of reports.
std::string tone_of(PartState state) {
    return std::string(state == PartState::error ? "fail" : name_of(state));
}

std::string row_of(const PartOutcome& part) {
    const std::string name = html_escaped(part.name);
    const std::string link =
        part.page.empty() ? name
                          : "<a href=\"" + html_escaped(part_folder(part.name) + "/" + part.page) +
                                "\">" + name + "</a>";
    return "<tr>" + html_cell(name, link, "left") +
           html_cell(std::to_string(static_cast<int>(part.state)),
                     "<span class=\"chip " + tone_of(part.state) + "\">" +
                         std::string(name_of(part.state)) + "</span>") +
           html_words_cell(part.summary) + html_words_cell(part.file) + "</tr>\n";
}

std::string head_of(const PartsRun& run) {
    std::string html = "<header class=\"card head " + tone_of(run.state()) +
                       "\"><div class=\"verdict\">" + std::string(name_of(run.state())) +
                       "</div><div class=\"names\"><h1>keiko " + html_escaped(run.command) +
                       " of " + counted(run.parts.size(), "part") +
                       "</h1></div></header>\n<div class=\"counts\">";
    for (const PartState state : every_part_state) {
        const std::size_t number = run.count(state);
        html += "<div class=\"card count " + tone_of(state) + (number == 0 ? " none" : "") +
                "\"><b>" + std::to_string(number) + "</b>" + std::string(name_of(state)) + "</div>";
    }
    return html + "</div>\n";
}

JunitCase case_of(const PartsRun& run, const PartOutcome& part) {
    using enum JunitCase::Outcome;
    JunitCase junit{.class_name = "keiko." + run.command, .name = part.name};
    if (part.state == PartState::pass) return junit;
    junit.outcome = part.state == PartState::error ? error : failure;
    junit.message = part.summary;
    return junit;
}

} // namespace

std::string_view name_of(PartState state) {
    constexpr std::array<std::string_view, every_part_state.size()> names{"pass", "undecided",
                                                                          "fail", "error"};
    return names[static_cast<std::size_t>(state)];
}

std::size_t PartsRun::count(PartState state) const {
    return static_cast<std::size_t>(std::count_if(
        parts.begin(), parts.end(), [&](const PartOutcome& part) { return part.state == state; }));
}

PartState PartsRun::state() const {
    PartState worst = PartState::pass;
    for (const PartOutcome& part : parts) worst = std::max(worst, part.state);
    return worst;
}

std::string summary_of(const PartsRun& run) {
    std::string text = counted(run.parts.size(), "part");
    for (const PartState state : every_part_state)
        text += ", " + std::to_string(run.count(state)) + " " + std::string(name_of(state));
    return text;
}

std::string part_json(const PartOutcome& outcome, const std::string& key) {
    Json json = outcome_json(outcome);
    json["key"] = key;
    return text_of(json);
}

PartOutcome parse_part(const std::string& text, const std::string& key, const std::string& file) {
    return with_errors_named(file, "", [&]() -> PartOutcome {
        const Json json = Json::parse(text);
        if (json.at("key") != key) return {};
        return outcome_from(json);
    });
}

std::string parts_json(const PartsRun& run) {
    Json json = {
        {"format", format},       {"tool", {{"name", "keiko"}, {"version", run.tool_version}}},
        {"command", run.command}, {"state", name_of(run.state())},
        {"key", run.key},         {"shard", run.shard},
        {"shards", run.shards},   {"all", run.all},
        {"parts", Json::array()}};
    for (const PartOutcome& part : run.parts) json["parts"].push_back(outcome_json(part));
    return text_of(json);
}

PartsRun parse_parts(const std::string& text, const std::string& file) {
    return with_errors_named(file, "", [&] { return run_from(Json::parse(text)); });
}

std::string part_folder(const std::string& name) {
    return "parts/" + name + "/results";
}

std::string parts_html(const PartsRun& run) {
    std::string body = head_of(run) + html_table_head({"part", "verdict", "summary", "file"},
                                                      {"part", "summary", "file"});
    for (const PartOutcome& part : run.parts) body += row_of(part);
    return html_page("Keiko: " + html_escaped(run.command), "", body + std::string(html_table_end),
                     report_script);
}

std::string parts_junit(const PartsRun& run) {
    JunitSuite suite{.name = "keiko " + run.command};
    for (const PartOutcome& part : run.parts) suite.cases.push_back(case_of(run, part));
    return junit_xml(std::vector{std::move(suite)});
}

} // namespace keiko
