#pragma once

#include "keiko/base/job.h"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <string>

namespace keiko::test {

/// Stop query that measures the work that a thread does between two queries: its processor time,
/// which other programs do not change. By stage of the progress. Asks to stop after a time.
class StopGaps {
public:
    /// `enough`: s of work of all threads, after which the work is to stop.
    explicit StopGaps(double enough) : enough_(enough), scope_([this] { return note(); }) {
        note();
    }

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
        const std::scoped_lock lock(mutex_);
        if (last.number == number_) {
            double& longest = longest_[stage_];
            longest = std::max(longest, now - last.time);
            total_ += now - last.time;
        }
        last = {number_, now};
        return total_ > enough_;
    }

    /// Seconds of this thread.
    static double processor_time() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    static inline std::atomic<int> count_{0};

    int number_ = ++count_;
    double enough_, total_ = 0;
    std::mutex mutex_;
    std::string stage_ = "begin";
    std::map<std::string, double> longest_;
    StopScope scope_;
};

} // namespace keiko::test
