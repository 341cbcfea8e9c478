#include "keiko/report/sarif.h"

#include "keiko/report/check_place.h"
#include "keiko/report/json_text.h"

#include <algorithm>
#include <cstdio>

namespace keiko {
namespace {

using Files = std::span<const std::filesystem::path>;

/// A path as a URI reference (RFC 3986): every byte that is not plain is escaped.
std::string uri_of(const std::string& path) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        if (plain.find(c) != std::string_view::npos) {
            uri += c;
            continue;
        }
        char escaped[4];
        std::snprintf(escaped, sizeof escaped, "%%%02X", static_cast<unsigned char>(c));
        uri += escaped;
    }
    return uri;
}

/// The criteria of the run in the order in which they were first asked.
std::vector<const Criterion*> rules_of(const Inspection& inspection) {
    std::vector<const Criterion*> rules;
    for (const Check& check : inspection.checks) {
        const Criterion* rule = &criterion_of(check.code);
        if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
    }
    return rules;
}

/// A message that holds no arguments and no links: braces and brackets of names would be taken for
/// such (SARIF 2.1.0, 3.11.5 and 3.11.6).
Json text(std::string_view message) {
    std::string plain;
    for (std::size_t i = 0; i < message.size(); ++i) {
        const char c = message[i];
        if (c == '{' || c == '}') plain += c;
        if (c == ']' && message.substr(i + 1).starts_with('(')) plain += '\\';
        plain += c;
    }
    return {{"text", plain}};
}

Json rule_json(const Criterion& rule) {
    return {{"id", rule.code},
            {"name", rule.rule.empty() ? rule.quantity : rule.rule},
            {"shortDescription", text(rule.description)},
            {"defaultConfiguration", {{"level", "error"}}}};
}

Json artifact(const std::filesystem::path& file, std::size_t index) {
    return {{"uri", uri_of(file.string())}, {"index", index}};
}

Json location(const Check& check, Files files) {
    Json json;
    if (files.size() == 1)
        json["physicalLocation"] = {{"artifactLocation", artifact(files.front(), 0)}};
    json["logicalLocations"] = Json::array({{{"name", check.faces},
                                             {"fullyQualifiedName", subject_of(check)},
                                             {"kind", check.face == no_index ? "seam" : "face"}}});
    return json;
}

Json result(const Check& check, const std::vector<const Criterion*>& rules, Files files) {
    const Worst& worst = check.worst;
    const auto index =
        std::find(rules.begin(), rules.end(), &criterion_of(check.code)) - rules.begin();
    Json properties = {{"verdict", name_of(worst.verdict)},
                       {"quantity", check.quantity},
                       {"value", worst.value},
                       {"bound", worst.bound},
                       {"limit", worst.limit},
                       {"unit", check.unit},
                       {"place", point(worst.place)}};
    if (!check.formula.empty()) properties["formula"] = check.formula;
    return {{"ruleId", check.code},
            {"ruleIndex", index},
            {"level", worst.verdict == Verdict::fail ? "error" : "warning"},
            {"message", text(placed_message(check))},
            {"locations", Json::array({location(check, files)})},
            {"properties", properties}};
}

/// What kept the run from seeing the whole model.
Json invocation(const Inspection& inspection) {
    Json json = {{"executionSuccessful", true}};
    for (const LostFace& face : inspection.facts.lost_faces)
        json["toolExecutionNotifications"].push_back(
            {{"level", "error"},
             {"message", text("face " + std::to_string(face.id) + " is missing: " + face.reason)}});
    return json;
}

} // namespace

std::string sarif_json(const Inspection& inspection, const std::string& tool_version, Files files) {
    const std::vector<const Criterion*> rules = rules_of(inspection);
    Json driver = {{"name", "Keiko"}, {"version", tool_version}, {"rules", Json::array()}};
    for (const Criterion* rule : rules) driver["rules"].push_back(rule_json(*rule));
    Json results = Json::array();
    for (const Check& finding : inspection.findings)
        results.push_back(result(finding, rules, files));
    Json artifacts = Json::array();
    for (std::size_t i = 0; i < files.size(); ++i)
        artifacts.push_back(
            {{"location", artifact(files[i], i)}, {"roles", Json::array({"analysisTarget"})}});
    const Json run = {{"tool", {{"driver", driver}}},
                      {"invocations", Json::array({invocation(inspection)})},
                      {"artifacts", artifacts},
                      {"results", results},
                      {"properties", {{"preset", inspection.preset.name}}}};
    return text_of({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", Json::array({run})}});
}

} // namespace keiko
