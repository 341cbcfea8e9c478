#include "keiko/batch/array_task.h"

#include "keiko/base/error.h"

#include <charconv>
#include <string_view>

namespace keiko {
namespace {

/// Value of a variable; nullopt where it is not set, or is what Grid Engine states outside of
/// arrays.
std::optional<int> value_of(const Environment& environment, const char* name) {
    const char* text = environment(name);
    if (!text || *text == '\0' || std::string_view(text) == "undefined") return std::nullopt;
    const std::string_view word = text;
    constexpr int most = 1'000'000'000;
    int value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size() || value < 0 || value > most)
        throw Error("", name, in_quotes(word) + " is no number of a task");
    return value;
}

/// Task whose neighbours are `step` apart from `first` on; without its place among them where that
/// cannot be, for some are missing.
ArrayTask regular_task(const char* variable, int index, int first, int step, int count) {
    const int offset = index - first;
    if (step < 1 || offset < 0 || offset % step != 0 || offset / step >= count)
        return {variable, index};
    return {variable, index, offset / step + 1, count};
}

std::optional<ArrayTask> slurm_task(const Environment& environment) {
    constexpr const char* variable = "SLURM_ARRAY_TASK_ID";
    const std::optional<int> index = value_of(environment, variable);
    if (!index) return std::nullopt;
    const auto count = value_of(environment, "SLURM_ARRAY_TASK_COUNT"),
               first = value_of(environment, "SLURM_ARRAY_TASK_MIN"),
               last = value_of(environment, "SLURM_ARRAY_TASK_MAX");
    if (!count || *count < 1 || !first || !last) return ArrayTask{variable, *index};
    const int spans = *count - 1, length = *last - *first;
    const int step = spans == 0 ? 1 : length % spans == 0 ? length / spans : 0;
    return regular_task(variable, *index, *first, step, *count);
}

std::optional<ArrayTask> grid_engine_task(const Environment& environment) {
    constexpr const char* variable = "SGE_TASK_ID";
    const std::optional<int> index = value_of(environment, variable);
    if (!index) return std::nullopt;
    const auto first = value_of(environment, "SGE_TASK_FIRST"),
               last = value_of(environment, "SGE_TASK_LAST"),
               step = value_of(environment, "SGE_TASK_STEPSIZE");
    if (!first || !last || !step || *step < 1) return ArrayTask{variable, *index};
    return regular_task(variable, *index, *first, *step, (*last - *first) / *step + 1);
}

std::optional<ArrayTask> uncounted_task(const Environment& environment, const char* variable,
                                        int first) {
    const std::optional<int> index = value_of(environment, variable);
    if (!index) return std::nullopt;
    return ArrayTask{variable, *index - first + 1};
}

std::optional<ArrayTask> gitlab_task(const Environment& environment) {
    constexpr const char* variable = "CI_NODE_INDEX";
    const auto index = value_of(environment, variable),
               count = value_of(environment, "CI_NODE_TOTAL");
    if (!index || !count) return std::nullopt;
    return regular_task(variable, *index, 1, 1, *count);
}

} // namespace

std::optional<ArrayTask> array_task(const Environment& environment) {
    if (auto task = slurm_task(environment)) return task;
    if (auto task = uncounted_task(environment, "PBS_ARRAY_INDEX", 1)) return task;
    if (auto task = grid_engine_task(environment)) return task;
    if (auto task = uncounted_task(environment, "JOB_COMPLETION_INDEX", 0)) return task;
    return gitlab_task(environment);
}

int array_threads(const Environment& environment) {
    if (!environment("SLURM_JOB_ID")) return 0;
    return value_of(environment, "SLURM_CPUS_PER_TASK").value_or(1);
}

} // namespace keiko
