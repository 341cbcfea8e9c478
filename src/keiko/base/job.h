#pragma once

#include "keiko/base/export.h"

#include <functional>
#include <stop_token>
#include <string_view>

namespace KEIKO_API keiko {

/// Progress of a long function.
struct Progress {
    std::string_view stage; ///< what is being done, e.g. "render"
    double fraction = 0;    ///< of this stage, 0 to 1
};

/// The last argument of every long function: where progress goes, when to stop, how many
/// threads to use. A default Job is silent, never stops and uses every core.
struct Job {
    std::function<void(const Progress&)> progress{}; ///< may be empty; calls never overlap
    std::stop_token stop{};                          ///< requested to end the work early
    int threads = 0;                                 ///< 0: as many as there are cores

    /// Reports how much of a stage is done, 0 to 1.
    void report(std::string_view stage, double fraction) const {
        if (progress) progress({stage, fraction});
    }
    /// Throws Cancelled once a stop was requested.
    void check() const;
};

/// Answer to whether work is to stop. Several threads may call it at once.
using StopQuery = std::function<bool()>;

/// The work of a thread between its construction and its destruction, which ends early once its
/// query returns true. Scopes nest, and each of them can end the work. parallel_for and
/// parallel_stream carry the scopes of their caller, and one of their Job, to every thread.
class StopScope {
public:
    /// Ends early once the query returns true.
    explicit StopScope(StopQuery requested);
    /// Ends early once the job is to stop.
    explicit StopScope(const Job& job);
    ~StopScope();
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

    /// True if this scope or one around it is to stop.
    bool stop_requested() const;

    /// The innermost scope of this thread; null outside of all.
    static const StopScope* innermost();

    /// A scope of another thread, taken over by this one for as long as this lives.
    class Shared {
    public:
        /// Takes over a scope, or none if null.
        explicit Shared(const StopScope* scope);
        ~Shared();
        Shared(const Shared&) = delete;
        Shared& operator=(const Shared&) = delete;

    private:
        const StopScope* before_;
    };

private:
    StopQuery requested_;
    const StopScope* outer_;
};

/// Throws Cancelled once a scope of this thread is to stop. Long loops without a Job call it every
/// millisecond or so. Never called below an Embree callback, which nothing may be thrown through.
void check_stop();

} // namespace keiko
