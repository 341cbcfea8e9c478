#include "keiko/batch/shard.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace keiko {
namespace {

constexpr std::string_view folder_prefix = "shard-";

/// The digits of a text as a number from 1; nullopt for another text.
std::optional<int> positive(std::string_view text) {
    constexpr int most = 100000;
    int value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = code == std::errc() && end == text.data() + text.size();
    if (!whole || value < 1 || value > most) return std::nullopt;
    return value;
}

ArrayTask task_of(const std::string& text, const Environment& environment) {
    std::optional<ArrayTask> task;
    try {
        task = array_task(environment);
    } catch (const Error& error) {
        throw FieldError("shard", in_quotes(text) + ": " + error.what());
    }
    if (!task)
        throw FieldError("shard", in_quotes(text) +
                                      ": this is no task of an array: none of "
                                      "SLURM_ARRAY_TASK_ID, PBS_ARRAY_INDEX, SGE_TASK_ID, "
                                      "JOB_COMPLETION_INDEX and CI_NODE_INDEX is set");
    return *task;
}

Shard automatic_shard(const std::string& text, const Environment& environment) {
    const ArrayTask task = task_of(text, environment);
    if (!task.count)
        throw FieldError("shard", in_quotes(text) + ": " + task.variable +
                                      " is of an array with gaps, or whose tasks are not counted; "
                                      "write auto/N for N shards");
    return {*task.number, *task.count};
}

} // namespace

Shard shard_of(const std::string& text, const Environment& environment) {
    if (text == "auto") return automatic_shard(text, environment);
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::string left = text.substr(0, slash);
    const std::optional<int> count =
        positive(std::string_view(text).substr(std::min(slash + 1, text.size())));
    if (left == "auto" && count) {
        const ArrayTask task = task_of(text, environment);
        if (task.index < 1 || task.index > *count)
            throw FieldError("shard", in_quotes(text) + ": task " + std::to_string(task.index) +
                                          " of " + task.variable + " is none of 1 to " +
                                          std::to_string(*count));
        return {task.index, *count};
    }
    const std::optional<int> number = positive(left);
    if (!number || !count || *number > *count)
        throw FieldError("shard",
                         in_quotes(text) + " is none of K/N with 1 <= K <= N, auto and auto/N");
    return {*number, *count};
}

std::filesystem::path shard_folder(const std::filesystem::path& output, int number) {
    return output / (std::string(folder_prefix) + std::to_string(number));
}

bool is_shard_name(const std::string& name) {
    return name.starts_with(folder_prefix) &&
           positive(std::string_view(name).substr(folder_prefix.size()));
}

Job job_of_part(const Job& job, std::size_t index, std::size_t count, const std::string& name) {
    Job inner = job;
    if (!job.progress) return inner;
    const std::string prefix =
        std::to_string(index + 1) + "/" + std::to_string(count) + " " + name + ": ";
    inner.progress = [outer = job.progress, prefix](const Progress& progress) {
        const std::string stage = prefix + std::string(progress.stage);
        outer({stage, progress.fraction});
    };
    return inner;
}

} // namespace keiko
