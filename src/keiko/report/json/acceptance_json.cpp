#include "keiko/base/error.h"
#include "keiko/report/content/acceptance_texts.h"
#include "keiko/report/markup/json_errors.h"
#include "keiko/report/markup/json_members.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace keiko {
namespace {

constexpr const char* format = "keiko-accepted/1";
constexpr const char* list_key = "accepted";
constexpr double longest_reach = 1000; ///< mm

std::string date_at(const Json& json, const char* key, bool optional = false) {
    std::string date = text_at(json, key, optional);
    require(date.empty() || is_date(date), key, in_quotes(date) + " is no date as 2026-11-27");
    return date;
}

/// A number that is finite and not less than 0.
double number_at(const Json& json, const char* key) {
    const double number = json.at(key).get<double>();
    require(std::isfinite(number) && number >= 0, key, "is not a number from 0 on");
    return number;
}

Verdict verdict_at(const Json& json) {
    const std::string word = json.at("verdict").get<std::string>();
    require(word == "fail" || word == "undecided", "verdict", "is neither fail nor undecided");
    return word == "fail" ? Verdict::fail : Verdict::undecided;
}

std::string code_at(const Json& json) {
    const std::string code = text_at(json, "code");
    try {
        return std::string(criterion_of(code).code);
    } catch (const std::out_of_range&) {
        throw Error("", "code", "there is no criterion " + in_quotes(code));
    }
}

/// Keys common to an entry and a finding of a report.
Acceptance finding_from(const Json& json) {
    Acceptance entry;
    entry.code = code_at(json);
    entry.formula = text_at(json, "formula", true);
    entry.view = text_at(json, "view", true);
    entry.faces = text_at(json, "faces");
    entry.unit = text_at(json, "unit");
    entry.place = place_at(json, "place");
    entry.value = number_at(json, "value");
    entry.limit = number_at(json, "limit");
    entry.verdict = verdict_at(json);
    return entry;
}

Acceptance entry_from(const Json& json) {
    require_known_keys(
        json, {"code", "formula", "view", "faces", "place", "reach", "stretch", "value", "bound",
               "limit", "unit", "verdict", "who", "why", "when", "until"});
    Acceptance entry = finding_from(json);
    entry.bound = real_from(json.at("bound"));
    require(entry.bound >= 0, "bound", "is not a number from 0 on");
    entry.reach = number_at(json, "reach");
    require(entry.reach > 0 && entry.reach <= longest_reach, "reach",
            "is not above 0 and at most 1000 mm");
    if (json.contains("stretch")) {
        const Json& stretch = json.at("stretch");
        require_known_keys(stretch, {"middle", "length"});
        entry.stretch = {place_at(stretch, "middle"), number_at(stretch, "length")};
    }
    entry.note = {text_at(json, "who"), text_at(json, "why"), date_at(json, "when"),
                  date_at(json, "until", true)};
    return entry;
}

Json entry_json(const Acceptance& entry) {
    Json json = {{"code", entry.code}};
    if (!entry.formula.empty()) json["formula"] = entry.formula;
    if (!entry.view.empty()) json["view"] = entry.view;
    json["faces"] = entry.faces;
    json["place"] = point(entry.place);
    json["reach"] = entry.reach;
    if (entry.stretch)
        json["stretch"] = {{"middle", point(entry.stretch->middle)},
                           {"length", entry.stretch->length}};
    json["value"] = entry.value, json["bound"] = real_json(entry.bound);
    json["limit"] = entry.limit, json["unit"] = entry.unit;
    json["verdict"] = name_of(entry.verdict);
    json["who"] = entry.note.who, json["why"] = entry.note.why, json["when"] = entry.note.when;
    if (!entry.note.until.empty()) json["until"] = entry.note.until;
    return json;
}

Json list_from(const std::string& text) {
    Json json = Json::parse(text);
    require(json.is_object() && json.contains("format") && json["format"] == format, "",
            std::string("is not of the format ") + format);
    require_known_keys(json, {"format", list_key});
    require(json.at(list_key).is_array(), list_key, "is no array");
    return json.at(list_key);
}

Json report_from(const std::string& text) {
    Json json = Json::parse(text);
    const Json kind = json.is_object() && json.contains("format") ? json["format"] : Json();
    require(kind == "keiko-inspection/1" || kind == "keiko-report/1", "",
            "is no report in JSON of keiko check or keiko inspect");
    require(json.at("findings").is_array(), "findings", "is no array");
    return json;
}

const Json& numbered(const Json& array, std::size_t number, const std::string& kind) {
    require(number >= 1 && number <= array.size(), "",
            "there is no such " + kind + "; there are " + std::to_string(array.size()));
    return array[number - 1];
}

bool is_judged(const Json& finding) {
    return finding.at("severity") == "judged";
}

/// Numbers of the judged findings of an item. Hidden faults are numbered on after the others.
std::vector<std::size_t> findings_of_item(const Json& report, std::size_t item) {
    if (!report.contains("triage")) return {item};
    Json faults = report.at("triage").at("items");
    for (const Json& hidden : report.at("triage").at("hidden")) faults.push_back(hidden);
    const Json& fault = numbered(faults, item, "fault");
    std::vector<std::size_t> judged;
    for (const Json& number : fault.at("findings")) {
        const std::size_t finding = number.get<std::size_t>();
        if (is_judged(numbered(report.at("findings"), finding, "finding")))
            judged.push_back(finding);
    }
    require(!judged.empty(), "", "is worth a look alone: it has no part in the verdict");
    return judged;
}

Acceptance acceptance_of_finding(const Json& report, std::size_t number,
                                 const AcceptanceNote& note) {
    const Json& finding = numbered(report.at("findings"), number, "finding");
    require(is_judged(finding), "", "is worth a look alone: it has no part in the verdict");
    Acceptance entry = finding_from(finding);
    const Json& bound = finding.at("bound"); // null if there is none
    entry.bound = bound.is_null() ? std::numeric_limits<double>::infinity() : real_from(bound);
    entry.reach = acceptance_reach, entry.note = note;
    if (!finding.contains("seam")) return entry;
    const Json& seam = report.at("seams").at(count_at<std::size_t>(finding, "seam") - 1);
    entry.stretch = {place_at(seam, "middle"), number_at(seam, "length")};
    entry.reach = acceptance_reach_on(entry.stretch->length);
    return entry;
}

} // namespace

std::string acceptances_json(std::span<const Acceptance> entries) {
    Json json = {{"format", format}, {list_key, Json::array()}};
    for (const Acceptance& entry : entries) json[list_key].push_back(entry_json(entry));
    return text_of(json);
}

std::vector<Acceptance> acceptances_from_json(const std::string& text, const std::string& file) {
    const Json list = with_errors_named(file, "", [&] { return list_from(text); });
    std::vector<Acceptance> entries;
    for (const Json& json : list) {
        const std::string part = "entry " + std::to_string(entries.size() + 1);
        entries.push_back(with_errors_named(file, part, [&] { return entry_from(json); }));
        for (std::size_t i = 0; i + 1 < entries.size(); ++i)
            if (accept_the_same(entries[i], entries.back()))
                throw Error(file, part, "accepts what entry " + std::to_string(i + 1) + " does");
    }
    return entries;
}

std::vector<Acceptance> acceptances_of_report(const std::string& text, const std::string& file,
                                              const AcceptedNumbers& numbers,
                                              const AcceptanceNote& note) {
    const Json report = with_errors_named(file, "", [&] { return report_from(text); });
    std::vector<Acceptance> entries;
    std::set<std::size_t> known;
    const auto add = [&](std::size_t finding, const std::string& part) {
        if (known.insert(finding).second)
            entries.push_back(with_errors_named(
                file, part, [&] { return acceptance_of_finding(report, finding, note); }));
    };
    for (const std::size_t item : numbers.items) {
        const std::string part = "item " + std::to_string(item);
        for (const std::size_t finding :
             with_errors_named(file, part, [&] { return findings_of_item(report, item); }))
            add(finding, part);
    }
    for (const std::size_t finding : numbers.findings)
        add(finding, "finding " + std::to_string(finding));
    return entries;
}

} // namespace keiko
