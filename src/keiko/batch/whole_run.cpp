#include "keiko/batch/whole_run.h"

#include "keiko/base/error.h"
#include "keiko/base/output_folder.h"
#include "keiko/base/text.h"

#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// Folders of finished shards in the output folder of a run, by number.
std::vector<fs::path> finished_shards(const fs::path& output, const std::string& record) {
    std::map<std::pair<std::size_t, std::string>, fs::path> found; // "shard-10" after "shard-9"
    std::error_code ignored; // a folder that cannot be read has no shards
    for (const fs::directory_entry& entry : fs::directory_iterator(output, ignored)) {
        const std::string name = entry.path().filename().string();
        if (is_shard_name(name) && fs::exists(entry.path() / record, ignored))
            found.emplace(std::pair(name.size(), name), entry.path());
    }
    std::vector<fs::path> folders;
    for (const auto& [order, folder] : found) folders.push_back(folder);
    return folders;
}

void require_same_run(const ShardRecord& one, const ShardRecord& first) {
    const auto fail = [&](const std::string& what) {
        throw Error(one.folder.string(), "", "is a shard of another run: " + what);
    };
    if (one.tool_version != first.tool_version)
        fail("it is of Keiko " + one.tool_version + ", " + first.folder.string() + " of " +
             first.tool_version);
    if (one.parts != first.parts) fail("it has other parts");
    if (one.shard.count != first.shard.count)
        fail("it is one of " + counted(static_cast<std::size_t>(one.shard.count), "shard") +
             ", not of " + std::to_string(first.shard.count));
    if (one.key != first.key)
        fail("files, options, baselines or the program were others when it ran");
}

/// The record that shards of a plan would have.
ShardRecord record_of(const ShardPlan& plan) {
    ShardRecord record{"shards.json", {1, plan.shards}, plan.tool_version, plan.key, {}, {}};
    for (const PlannedPart& part : plan.parts) record.parts.push_back(part.name);
    return record;
}

/// "shards 2, 5 of 8 are missing, and with them a, b, c"
std::string missing_text(const std::vector<int>& missing, int count, const ShardPlan* plan) {
    std::vector<std::string> numbers, parts;
    for (const int number : missing) {
        numbers.push_back(std::to_string(number));
        if (!plan) continue;
        for (const PlannedPart& part : plan->parts)
            if (part.shard == number) parts.push_back(part.name);
    }
    const bool one = missing.size() == 1;
    std::string text = (one ? "shard " : "shards ") + comma_list(numbers) + " of " +
                       std::to_string(count) + (one ? " is missing" : " are missing");
    if (!parts.empty()) text += ", with " + comma_list(parts);
    return text + "; run again as shard " + numbers.front() + "/" + std::to_string(count);
}

void require_every_shard(const std::set<int>& present, int count, const ShardPlan* plan) {
    std::vector<int> missing;
    for (int number = 1; number <= count; ++number)
        if (!present.contains(number)) missing.push_back(number);
    if (!missing.empty()) throw Error("", "", missing_text(missing, count, plan));
}

void require_every_part(std::span<const ShardRecord> records,
                        const std::vector<std::string>& parts) {
    std::set<std::string> done;
    for (const ShardRecord& record : records) done.insert(record.done.begin(), record.done.end());
    for (const std::string& part : parts)
        if (!done.contains(part)) throw Error("", "", in_quotes(part) + " is in no shard");
}

} // namespace

ShardFolders shard_folders(std::span<const fs::path> named, const std::string& record) {
    ShardFolders all;
    for (const fs::path& folder : named) {
        std::optional<ShardPlan> plan = kept_plan(folder);
        const std::vector<fs::path> inside = finished_shards(folder, record);
        if (!plan && inside.empty())
            all.folders.push_back(folder);
        else
            all.folders.insert(all.folders.end(), inside.begin(), inside.end());
        if (plan && !all.plan) all.plan = std::move(plan);
    }
    return all;
}

void require_whole_run(std::span<const ShardRecord> records, const std::optional<ShardPlan>& plan) {
    if (records.empty() && !plan) throw Error("", "", "no shard is there");
    const ShardRecord first = plan ? record_of(*plan) : records.front();
    std::map<int, fs::path> places;
    for (const ShardRecord& record : records) {
        require_same_run(record, first);
        const auto [at, added] = places.emplace(record.shard.number, record.folder);
        if (!added)
            throw Error(record.folder.string(), "",
                        "is shard " + std::to_string(record.shard.number) + ", as is " +
                            at->second.string());
    }
    std::set<int> present;
    for (const auto& [number, folder] : places) present.insert(number);
    require_every_shard(present, first.shard.count, plan ? &*plan : nullptr);
    require_every_part(records, first.parts);
}

void withdraw_reports(const fs::path& output, const std::string& record) {
    if (!fs::is_directory(output)) return;
    const FolderLock lock(output);
    std::error_code ignored; // what cannot be removed shows when it is written
    for (const std::string& name : {record, std::string("junit.xml"), std::string("index.html")})
        fs::remove(output / name, ignored);
}

} // namespace keiko
