#include "keiko/base/sha256.h"
#include "keiko/inspect/inspection.h"
#include "keiko/report/content/acceptance_texts.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/markup/json_text.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

namespace keiko {
namespace {

/// The files of a SARIF run, in the order of FaceFacts::file.
using SarifFiles = std::span<const std::filesystem::path>;

/// Place of a face in one of the files, by line from 1.
struct SarifPlace {
    std::string face;       ///< its name, or else "face 12"
    std::uint32_t file = 0; ///< into the files of the run
    std::uint32_t line = 1; ///< at least 1
};

constexpr const char* root = "ROOT"; ///< the folder that absolute paths begin in

/// A path as a relative URI reference: every byte that is not plain is escaped.
std::string uri_of(std::string_view path) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    path.remove_prefix(std::min(path.find_first_not_of('/'), path.size()));
    std::string uri;
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

SarifPlace place_of(std::uint32_t face, const Inspection& inspection) {
    const std::vector<FaceFacts>& faces = inspection.facts.face_list;
    if (face >= faces.size()) return {};
    const FaceFacts& facts = faces[face];
    return {facts.name.empty() ? "face " + std::to_string(facts.id) : facts.name, facts.file,
            std::max(facts.line, 1u)};
}

std::vector<SarifPlace> sides_of(const MeasuredSeam& seam, const Inspection& inspection) {
    std::vector<SarifPlace> places{place_of(seam.face_a, inspection)};
    if (!seam.internal) places.push_back(place_of(seam.face_b, inspection));
    return places;
}

/// The one or two faces of a check. Without a known face: line 1 of the first file.
std::vector<SarifPlace> places_of(const Check& check, const Inspection& inspection) {
    if (check.seam != no_index) return sides_of(inspection.seams.at(check.seam), inspection);
    if (check.face != no_index) return {place_of(inspection.faces.at(check.face).face, inspection)};
    const auto crossed =
        std::find_if(inspection.seams.begin(), inspection.seams.end(),
                     [&](const MeasuredSeam& seam) { return seam.faces == check.faces; });
    if (crossed != inspection.seams.end()) return sides_of(*crossed, inspection);
    return {SarifPlace{.face = check.faces}};
}

/// SARIF artifactLocation of a file: a percent-encoded relative reference [RFC3986], to the base
/// `ROOT` where the path is absolute.
Json artifact_location(const std::filesystem::path& file, std::size_t index) {
    Json json = {{"uri", uri_of(file.string())}};
    if (file.is_absolute()) json["uriBaseId"] = root;
    json["index"] = index;
    return json;
}

/// SARIF physicalLocation of a place; null without files.
Json physical_location(const SarifPlace& place, SarifFiles files) {
    if (files.empty()) return nullptr;
    const std::size_t file = place.file < files.size() ? place.file : 0;
    return {{"artifactLocation", artifact_location(files[file], file)},
            {"region", {{"startLine", place.line}}}};
}

/// SARIF originalUriBaseIds of a run: of `ROOT`, if a path is absolute; else an empty object.
Json uri_bases(SarifFiles files) {
    Json bases = Json::object();
    if (std::any_of(files.begin(), files.end(),
                    [](const auto& file) { return file.is_absolute(); }))
        bases[root] = {{"uri", "file:///"}};
    return bases;
}

/// The criteria of the run in the order of their first use.
std::vector<const Criterion*> rules_of(const Inspection& inspection) {
    std::vector<const Criterion*> rules;
    for (const Check& check : inspection.checks) {
        const Criterion* rule = &criterion_of(check.code);
        if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
    }
    return rules;
}

/// A message without arguments and links: braces and brackets of names would be read as such (SARIF
/// 2.1.0, 3.11.5 and 3.11.6).
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

std::string help_of(const Criterion& rule) {
    return std::string(rule.description) +
           " An error is over the limit of the preset; a warning cannot be distinguished from it "
           "within the error bound of its measurement.";
}

Json rule_json(const Criterion& rule) {
    return {{"id", rule.code},
            {"name", rule.rule.empty() ? rule.quantity : rule.rule},
            {"shortDescription", text(rule.description)},
            {"fullDescription", text(rule.description)},
            {"help", text(help_of(rule))},
            {"defaultConfiguration", {{"level", "error"}}}};
}

Json location(const Check& check, const SarifPlace& place, SarifFiles files) {
    Json json;
    if (Json physical = physical_location(place, files); !physical.is_null())
        json["physicalLocation"] = std::move(physical);
    json["logicalLocations"] = Json::array({{{"name", check.faces},
                                             {"fullyQualifiedName", subject_of(check)},
                                             {"kind", check.face == no_index ? "seam" : "face"}}});
    return json;
}

const char* level_of(const Check& check) {
    if (check.is_worth_a_look()) return "note";
    return check.worst.verdict == Verdict::fail ? "error" : "warning";
}

Json related_location(const SarifPlace& place, SarifFiles files) {
    return {{"id", 1},
            {"physicalLocation", physical_location(place, files)},
            {"message", text(place.face)}};
}

Json properties_of(const Check& check) {
    const MeasuredValue& worst = check.worst;
    Json properties = {{"verdict", outcome_of(check)}, {"quantity", check.quantity},
                       {"value", worst.value},         {"bound", worst.bound},
                       {"limit", worst.limit},         {"unit", check.unit},
                       {"place", point(worst.place)}};
    if (!check.formula.empty()) properties["formula"] = check.formula;
    return properties;
}

/// Hash of the properties that a finding keeps from one run to the next: its code, and the names
/// and files of its faces. Numbers of seams and measured values change.
std::string fingerprint(const Check& check, std::span<const SarifPlace> places, SarifFiles files) {
    constexpr std::size_t digits = 16;
    std::string identity = check.code + "\n" + check.view;
    for (const SarifPlace& place : places) {
        identity += "\n" + place.face;
        if (place.file < files.size()) identity += "\n" + files[place.file].filename().string();
    }
    return sha256_hex(identity).substr(0, digits);
}

/// SARIF suppressions of a result: one if its finding is accepted, else none.
Json suppressions_of(const Check& check) {
    if (!check.accepted) return Json::array();
    const Json one = {
        {"kind", "external"}, {"status", "accepted"}, {"justification", text_of(*check.accepted)}};
    return Json::array({one});
}

/// Writes the results of one run.
class SarifResults {
public:
    SarifResults(const Inspection& inspection, const std::vector<const Criterion*>& rules,
                 SarifFiles files)
        : inspection_(inspection), rules_(rules), files_(files) {}

    Json result(const Check& check) {
        const std::vector<SarifPlace> places = places_of(check, inspection_);
        Json json = {{"ruleId", check.code},
                     {"ruleIndex", rule_index(check)},
                     {"level", level_of(check)},
                     {"message", text(placed_message(check))},
                     {"locations", Json::array({location(check, places.front(), files_)})}};
        if (places.size() > 1 && !files_.empty())
            json["relatedLocations"] = Json::array({related_location(places[1], files_)});
        json["partialFingerprints"] = {
            {"primaryLocationLineHash", numbered(fingerprint(check, places, files_))}};
        // Either all results of a run have the property or none (SARIF 2.1.0, 3.27.23).
        if (!inspection_.accepted.empty()) json["suppressions"] = suppressions_of(check);
        json["properties"] = properties_of(check);
        return json;
    }

private:
    std::ptrdiff_t rule_index(const Check& check) const {
        return std::find(rules_.begin(), rules_.end(), &criterion_of(check.code)) - rules_.begin();
    }

    /// Hash with a number that separates it from earlier ones: two dents of one face have the same
    /// hash.
    std::string numbered(const std::string& hash) {
        return hash + ":" + std::to_string(++uses_[hash]);
    }

    const Inspection& inspection_;
    const std::vector<const Criterion*>& rules_;
    SarifFiles files_;
    std::map<std::string, int> uses_;
};

/// The findings that fit into a run: failures before undecided ones, otherwise in their order, then
/// those that are accepted, and last those that deserve a look.
std::vector<const Check*> top_findings(const Inspection& inspection) {
    std::vector<const Check*> top;
    for (const Check& finding : inspection.findings) top.push_back(&finding);
    std::stable_sort(top.begin(), top.end(), [](const Check* a, const Check* b) {
        return a->worst.verdict > b->worst.verdict;
    });
    for (const Check& accepted : inspection.accepted) top.push_back(&accepted);
    for (const Check& look : inspection.looks) top.push_back(&look);
    top.resize(std::min(top.size(), most_sarif_results));
    return top;
}

Json notification(const char* level, const std::string& message) {
    return {{"level", level}, {"message", text(message)}};
}

/// Invocation, with notifications of everything that the results omit.
Json invocation(const Inspection& inspection) {
    Json json = {{"executionSuccessful", true}};
    Json& notifications = json["toolExecutionNotifications"] = Json::array();
    for (const LostFace& face : inspection.facts.lost_faces)
        notifications.push_back(notification(
            "error", "face " + std::to_string(face.id) + " is missing: " + face.reason));
    for (const AcceptanceRemark& remark : inspection.acceptance_remarks)
        notifications.push_back(notification("warning", text_of(remark)));
    const std::size_t found =
        inspection.findings.size() + inspection.accepted.size() + inspection.looks.size();
    if (found > most_sarif_results)
        notifications.push_back(notification(
            "warning", std::to_string(found - most_sarif_results) + " of " + std::to_string(found) +
                           " findings are left out: a run has at most " +
                           std::to_string(most_sarif_results) + " results"));
    return json;
}

Json artifacts_of(SarifFiles files) {
    Json artifacts = Json::array();
    for (std::size_t i = 0; i < files.size(); ++i)
        artifacts.push_back({{"location", artifact_location(files[i], i)},
                             {"roles", Json::array({"analysisTarget"})}});
    return artifacts;
}

} // namespace

std::string sarif_json(const Inspection& inspection, const std::string& tool_version,
                       std::span<const std::filesystem::path> files) {
    const std::vector<const Criterion*> rules = rules_of(inspection);
    Json driver = {{"name", "Keiko"}, {"version", tool_version}, {"rules", Json::array()}};
    for (const Criterion* rule : rules) driver["rules"].push_back(rule_json(*rule));
    SarifResults writer(inspection, rules, files);
    Json results = Json::array();
    for (const Check* finding : top_findings(inspection))
        results.push_back(writer.result(*finding));
    Json properties = {{"preset", inspection.preset.name}};
    const auto sentences = scope_sentences(inspection.scope, inspection.preset);
    if (!sentences.empty()) properties["scope"] = sentences;
    const Json run = {{"tool", {{"driver", driver}}},
                      {"invocations", Json::array({invocation(inspection)})},
                      {"originalUriBaseIds", uri_bases(files)},
                      {"artifacts", artifacts_of(files)},
                      {"results", results},
                      {"properties", properties}};
    const Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({run})}};
    return text_of(log);
}

} // namespace keiko
