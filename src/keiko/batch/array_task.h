#pragma once

#include "keiko/base/export.h"

#include <functional>
#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// Value of an environment variable; null if it is not set. std::getenv is one.
using Environment = std::function<const char*(const char* name)>;

/// Task of an array job, as its scheduler states it in environment variables.
struct ArrayTask {
    std::string variable;        ///< that states the task, e.g. "SLURM_ARRAY_TASK_ID"
    int index = 0;               ///< as the user sees it; from 1 where the scheduler counts from 0
    std::optional<int> number{}; ///< place among the tasks, from 1; none without `count`
    std::optional<int> count{};  ///< of the tasks; none in an array with gaps, or if not stated
};

/// Task that this process runs: of Slurm, PBS, Grid Engine, an indexed Kubernetes job, or of a
/// parallel GitLab job, the first of them that is there. nullopt outside of an array. Throws Error
/// for a value that is no number.
std::optional<ArrayTask> array_task(const Environment& environment);

/// Threads of a task: Slurm's CPUs of the task, one where the job requested none. 0, as many as
/// there are cores, outside of Slurm.
int array_threads(const Environment& environment);

} // namespace keiko
