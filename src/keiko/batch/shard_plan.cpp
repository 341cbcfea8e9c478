#include "keiko/batch/shard_plan.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/batch/balanced_shards.h"
#include "keiko/report/markup/json_errors.h"
#include "keiko/report/markup/json_text.h"
#include "keiko/workflow/version.h"

#include <map>
#include <system_error>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr const char* format = "keiko-shards/1";

fs::path plan_file(const fs::path& output) {
    return output / "shards.json";
}

ShardPlan plan_from(const Json& json) {
    if (json.at("format") != format) throw Error("", "format", std::string("is not ") + format);
    ShardPlan plan{.command = json.at("command"),
                   .tool_version = json.at("tool").at("version"),
                   .program = json.at("tool").at("program"),
                   .key = json.at("key"),
                   .shards = count_at<int>(json, "shards"),
                   .parts = {}};
    for (const Json& part : json.at("parts"))
        plan.parts.push_back({part.at("name"), part.at("key"), count_at<int>(part, "shard")});
    return plan;
}

/// "part 'hood' is not in it", of the first part that two plans do not share; else empty.
std::string part_difference(const ShardPlan& kept, const ShardPlan& plan) {
    std::map<std::string, std::string> keys;
    for (const PlannedPart& part : kept.parts) keys[part.name] = part.key;
    for (const PlannedPart& part : plan.parts) {
        const auto found = keys.find(part.name);
        if (found == keys.end()) return in_quotes(part.name) + " is not in it";
        if (found->second != part.key)
            return "files or options of " + in_quotes(part.name) + " were others";
        keys.erase(found);
    }
    return keys.empty() ? "" : in_quotes(keys.begin()->first) + " is in it";
}

/// Difference of a kept plan from that of this run, in words; empty where they are the same.
std::string difference(const ShardPlan& kept, const ShardPlan& plan) {
    if (kept.command != plan.command) return "it is one of keiko " + kept.command;
    if (kept.tool_version != plan.tool_version) return "it is of Keiko " + kept.tool_version;
    if (kept.program != plan.program)
        return "its build of Keiko and instruction set are " + kept.program + ", here " +
               plan.program;
    if (kept.shards != plan.shards)
        return "it has " + counted(static_cast<std::size_t>(kept.shards), "shard") + ", here " +
               std::to_string(plan.shards);
    if (std::string part = part_difference(kept, plan); !part.empty()) return part;
    return kept.key == plan.key ? "" : "its files or options were others";
}

} // namespace

ShardPlan balanced_plan(std::string command, std::string key, std::vector<PlannedPart> parts,
                        std::span<const double> costs, int shards) {
    const std::vector<int> numbers = balanced_shards(costs, shards);
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].shard = numbers[i];
    return {std::move(command), version(), program(), std::move(key), shards, std::move(parts)};
}

std::vector<std::size_t> share_of(const ShardPlan& plan, int shard) {
    std::vector<std::size_t> share;
    for (std::size_t i = 0; i < plan.parts.size(); ++i)
        if (plan.parts[i].shard == shard) share.push_back(i);
    return share;
}

std::string plan_json(const ShardPlan& plan) {
    Json json = {
        {"format", format},
        {"tool", {{"name", "keiko"}, {"version", plan.tool_version}, {"program", plan.program}}},
        {"command", plan.command},
        {"key", plan.key},
        {"shards", plan.shards},
        {"parts", Json::array()}};
    for (const PlannedPart& part : plan.parts)
        json["parts"].push_back({{"name", part.name}, {"key", part.key}, {"shard", part.shard}});
    return text_of(json);
}

ShardPlan parse_plan(const std::string& text, const std::string& file) {
    return with_errors_named(file, "", [&] { return plan_from(Json::parse(text)); });
}

std::optional<ShardPlan> kept_plan(const fs::path& output) {
    const fs::path file = plan_file(output);
    std::error_code ignored; // what cannot be read is reported below
    if (fs::status(file, ignored).type() == fs::file_type::not_found) return std::nullopt;
    return parse_plan(read_file(file), file.string());
}

void claim_shard(const fs::path& output, const ShardPlan& plan, int number) {
    const auto make = [](const fs::path& folder) {
        std::error_code code;
        fs::create_directories(folder, code);
        if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    };
    make(output);
    if (!kept_plan(output)) write_text_file(plan_file(output), plan_json(plan));
    // Of two runs that claim a folder at once, the later one has it.
    require_claimed(output, plan);
    make(shard_folder(output, number));
}

void require_claimed(const fs::path& output, const ShardPlan& plan) {
    const std::optional<ShardPlan> kept = kept_plan(output);
    const std::string file = plan_file(output).string();
    if (!kept) throw Error(file, "", "was removed while the run went on");
    if (const std::string other = difference(*kept, plan); !other.empty())
        throw Error(file, "",
                    "is the plan of another run: " + other +
                        "; name another folder, or remove the file once that run has ended");
}

} // namespace keiko
