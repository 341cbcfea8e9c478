#include "keiko/base/error.h"
#include "keiko/report/content/regression.h"
#include "keiko/report/json/json_parts.h"

#include <algorithm>

namespace keiko {
namespace {

constexpr const char* format = "keiko-regression/1";

using Value = std::optional<std::variant<double, std::string>>;

Json value_json(const Value& value) {
    if (!value) return {};
    if (const double* real = std::get_if<double>(&*value)) return {{"number", real_json(*real)}};
    return {{"word", std::get<std::string>(*value)}};
}

Value value_from(const Json& json) {
    if (json.is_null()) return {};
    if (json.contains("word")) return json.at("word").get<std::string>();
    return real_from(json.at("number"));
}

Json metric_json(const MetricDifference& d) {
    return {{"check", d.check},
            {"name", d.name},
            {"quantity", name_of(d.quantity)},
            {"before", value_json(d.before)},
            {"after", value_json(d.after)},
            {"allowed", d.allowed}};
}

MetricDifference metric_from(const Json& json) {
    return {json.at("check"),
            json.at("name"),
            quantity_by_name(json.at("quantity").get<std::string>()),
            value_from(json.at("before")),
            value_from(json.at("after")),
            json.at("allowed")};
}

Json fixture_json(const FixtureOutcome& fixture) {
    Json json = {{"name", fixture.name},
                 {"state", name_of(fixture.state)},
                 {"error", fixture.error},
                 {"checks", fixture.checks},
                 {"metrics_compared", fixture.metrics_compared},
                 {"metrics", Json::array()},
                 {"pictures", Json::array()}};
    for (const MetricDifference& metric : fixture.metrics)
        json["metrics"].push_back(metric_json(metric));
    for (const PictureOutcome& picture : fixture.pictures)
        json["pictures"].push_back(picture_outcome_json(picture));
    return json;
}

FixtureState state_from(const std::string& name) {
    for (const FixtureState state : every_fixture_state)
        if (name_of(state) == name) return state;
    throw Error("", in_quotes(name), "is no state of a fixture");
}

FixtureOutcome fixture_from(const Json& json) {
    FixtureOutcome fixture;
    fixture.name = json.at("name");
    fixture.state = state_from(json.at("state"));
    fixture.error = json.at("error");
    fixture.checks = json.at("checks").get<std::vector<std::string>>();
    fixture.metrics_compared = count_at<std::size_t>(json, "metrics_compared");
    for (const Json& metric : json.at("metrics")) fixture.metrics.push_back(metric_from(metric));
    for (const Json& picture : json.at("pictures"))
        fixture.pictures.push_back(picture_outcome_from(picture));
    return fixture;
}

/// Throws Error for unsound values. Names of fixtures are names of folders, into which a merge of
/// shards writes.
void require_sound(const Regression& regression) {
    if (regression.shard < 1 || regression.shard > regression.shards)
        throw Error("", "shard", "is none of those there are");
    for (const std::string& name : regression.suite)
        if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
            throw Error("", in_quotes(name), "is no name of a fixture");
    for (const FixtureOutcome& fixture : regression.fixtures)
        if (std::find(regression.suite.begin(), regression.suite.end(), fixture.name) ==
            regression.suite.end())
            throw Error("", in_quotes(fixture.name), "is no fixture of the suite");
}

Regression regression_from(const Json& json) {
    if (json.at("format") != format)
        throw Error("", "", std::string("is not of the format ") + format);
    Regression regression;
    regression.tool_version = json.at("tool").at("version");
    regression.suite = json.at("suite").get<std::vector<std::string>>();
    regression.suite_key = json.at("suite_key");
    regression.stale_baselines = json.at("stale_baselines").get<std::vector<std::string>>();
    regression.shard = count_at<int>(json, "shard");
    regression.shards = count_at<int>(json, "shards");
    for (const Json& fixture : json.at("fixtures"))
        regression.fixtures.push_back(fixture_from(fixture));
    require_sound(regression);
    return regression;
}

} // namespace

std::string regression_json(const Regression& regression) {
    Json json = {{"format", format},
                 {"tool", {{"name", "keiko"}, {"version", regression.tool_version}}},
                 {"state", name_of(regression.state())},
                 {"shard", regression.shard},
                 {"shards", regression.shards},
                 {"suite", regression.suite},
                 {"suite_key", regression.suite_key},
                 {"stale_baselines", regression.stale_baselines},
                 {"fixtures", Json::array()}};
    for (const FixtureOutcome& fixture : regression.fixtures)
        json["fixtures"].push_back(fixture_json(fixture));
    return text_of(json);
}

Regression parse_regression(const std::string& text, const std::string& file) {
    try {
        return regression_from(Json::parse(text));
    } catch (const Error& error) {
        throw Error(file, error.where(), error.reason());
    } catch (const std::exception& error) { // of the JSON library
        throw Error(file, "", "cannot be read: " + shortened(error.what()));
    }
}

} // namespace keiko
