#pragma once

#include "keiko/base/job.h"
#include "keiko/base/stop_scope.h"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <string>

namespace keiko::test {

/// Stop query that never asks to stop, and measures the work that a thread does between two
/// queries: its processor time, which other programs do not change. By stage of the progress.
class StopGaps {
public:
    StopGaps() : scope_([this] { return note(); }) { note(); }

    /// Reports its stages here.
    Job job(int threads = 0) {
        Job job;
        job.progress = [this](const Progress& progress) {
            const std::scoped_lock lock(mutex_);
            stage_ = progress.stage;
        };
        job.threads = threads;
        return job;
    }

    /// Seconds, by the stage at their end; what this thread has done since its last query counts.
    std::map<std::string, double> longest() {
        note();
        const std::scoped_lock lock(mutex_);
        return longest_;
    }

private:
    struct Last {
        int number = 0; ///< of the StopGaps
        double time = 0;
    };

    bool note() {
        static thread_local Last last;
        const double now = processor_time();
        if (last.number == number_) {
            const std::scoped_lock lock(mutex_);
            double& longest = longest_[stage_];
            longest = std::max(longest, now - last.time);
        }
        last = {number_, now};
        return false;
    }

    /// Seconds of this thread.
    static double processor_time() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    static inline std::atomic<int> count_{0};

    int number_ = ++count_;
    std::mutex mutex_;
    std::string stage_ = "begin";
    std::map<std::string, double> longest_;
    StopScope scope_;
};

} // namespace keiko::test
