#pragma once

#include "keiko/base/job.h"

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace keiko::viewer {

/// Progress of one kind of work.
struct WorkProgress {
    std::uint64_t number = 0; ///< rises with each
    std::string kind, stage;  ///< "still", "render"
    double fraction = 0;      ///< of this stage, 0 to 1; 1 once the work has ended
};

/// The work that is under way, of each client and kind the newest: what begins ends the one before
/// it. May be used by several threads.
class LatestWork {
public:
    /// One piece of work, from its begin to the end of this object.
    class Turn {
    public:
        /// Begins work, and ends that of the same client and kind.
        Turn(LatestWork& all, std::string client, std::string kind);
        ~Turn();
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

        /// Token of the end that somebody requests.
        std::stop_token stop() const { return stop_.get_token(); }
        /// Requests the end.
        void end() { stop_.request_stop(); }
        /// The job of the work, which reports its progress to the client's listener.
        Job job(int threads) const;

    private:
        LatestWork& all_;
        std::pair<std::string, std::string> who_; ///< client and kind
        std::stop_source stop_;
    };

    /// Ends all work, and all that begins from now on.
    void end_all();
    /// Waits for progress of a client's work later than `after`, some hundred milliseconds at most.
    /// Nothing if there is none, or if `stop` was requested.
    std::optional<WorkProgress> next_progress(const std::string& client, std::uint64_t after,
                                              const std::stop_token& stop);

private:
    void report(const std::string& client, WorkProgress progress);

    std::mutex mutex_;
    std::condition_variable_any told_;
    std::map<std::pair<std::string, std::string>, std::stop_source> running_;
    std::map<std::string, WorkProgress> progress_; ///< the last of each client that has work
    std::uint64_t reports_ = 0;
    bool ended_ = false;
};

} // namespace keiko::viewer
