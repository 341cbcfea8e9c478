#pragma once

#include "keiko/base/job.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace keiko::python {

/// Arguments that every long function has besides its own.
struct WorkOptions {
    pybind11::object progress; ///< called with stage and fraction, or None
    int threads = 0;           ///< 0: one a core
};

/// The link between a thread that works and the interpreter's own, which waits for it.
class Watch {
public:
    explicit Watch(const WorkOptions& options);

    /// The job of the working thread.
    const Job& job() const { return job_; }
    /// Hands on progress and signals. The interpreter's lock must be held. What Python raises stops
    /// the work.
    void look();
    /// Raises again what Python has raised.
    void raise() const;

private:
    void stop();

    pybind11::object progress_;
    std::stop_source stop_;
    Job job_;
    std::mutex mutex_;
    std::optional<std::pair<std::string, double>> latest_;
    std::unique_ptr<pybind11::error_already_set> raised_;
};

/// Does `work(job)` in a thread of its own, without the interpreter's lock, and returns its result.
/// Ctrl-C and what `progress` raises stop it.
template <class Work>
auto run(const WorkOptions& options, Work work) {
    constexpr std::chrono::milliseconds between(50);
    Watch watch(options);
    auto result = std::async(std::launch::async, [&] { return work(watch.job()); });
    bool is_ready = false;
    while (!is_ready) {
        {
            pybind11::gil_scoped_release released;
            is_ready = result.wait_for(between) == std::future_status::ready;
        }
        watch.look();
    }
    watch.raise();
    return result.get();
}

} // namespace keiko::python
