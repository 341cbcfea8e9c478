#pragma once

#include "keiko/batch/whole_run.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace keiko {

/// Members of the record of a shard that state which run it is of, for records of any kind.
/// Besides, a record has `tool_version`, `shard` and `shards`, and each of its parts a `name`.
template <class Run, class Part>
struct RunMembers {
    std::string Run::*key;              ///< SHA-256 of everything that the run depends on
    std::vector<std::string> Run::*all; ///< every part of the run, by name, in its order
    std::vector<Part> Run::*parts;      ///< those of the shard
};

/// Facts that the record of a shard in a folder states on its run.
template <class Run, class Part>
ShardRecord record_of(const Run& shard, const std::filesystem::path& folder,
                      const RunMembers<Run, Part>& members) {
    ShardRecord record{folder,
                       {shard.shard, shard.shards},
                       shard.tool_version,
                       shard.*members.key,
                       shard.*members.all,
                       {}};
    for (const Part& part : shard.*members.parts) record.done.push_back(part.name);
    return record;
}

/// The run that was divided into shards, as if it had not been. They are all of its shards.
template <class Run, class Part>
Run joined(std::vector<Run> shards, const RunMembers<Run, Part>& members) {
    std::map<std::string, Part> done;
    for (Run& shard : shards)
        for (Part& part : shard.*members.parts) done.emplace(part.name, std::move(part));
    Run whole = std::move(shards.front());
    whole.shard = whole.shards = 1;
    (whole.*members.parts).clear();
    for (const std::string& name : whole.*members.all)
        (whole.*members.parts).push_back(std::move(done.at(name)));
    return whole;
}

/// Reads the record in each folder by `read` and joins them. Throws Error as require_whole_run
/// does.
template <class Run, class Part, class Read>
Run joined_run(const ShardFolders& found, const RunMembers<Run, Part>& members, const Read& read) {
    std::vector<Run> shards;
    std::vector<ShardRecord> records;
    for (const std::filesystem::path& folder : found.folders) {
        shards.push_back(read(folder));
        records.push_back(record_of(shards.back(), folder, members));
    }
    require_whole_run(records, found.plan);
    return joined(std::move(shards), members);
}

} // namespace keiko
