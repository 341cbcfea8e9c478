#pragma once

#include "keiko/base/job.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace keiko {

/// Program, arguments and input of a worker.
struct WorkerCall {
    std::filesystem::path program;      ///< executable
    std::vector<std::string> arguments; ///< without its name
    std::string_view input{};           ///< on its stdin; empty: /dev/null
};

/// How a worker executable ended.
struct WorkerExit {
    bool timed_out = false;
    int signal = 0;                ///< it died of, 0: none
    int code = 0;                  ///< its exit code when it did not die of a signal
    std::uint64_t peak_memory = 0; ///< bytes that it held at most
    std::string last_complaint;    ///< last line it wrote to stderr
};

/// Runs a worker without a shell and without forking this process's threads, and hands whatever it
/// writes to file descriptor 3 to `receive`. Its stdout goes nowhere. It is killed, with its
/// children, after `timeout` and when `job` is stopped (then Cancelled is thrown). Throws Error
/// when it cannot be started.
WorkerExit run_worker(const WorkerCall& call, std::chrono::milliseconds timeout,
                      const std::function<void(std::string_view)>& receive, const Job& job);

} // namespace keiko
