#pragma once

#include <functional>

namespace keiko {

struct Job;

/// Answer to whether work is to stop. Several threads may call it at once.
using StopQuery = std::function<bool()>;

/// The work of a thread between its construction and its destruction, which ends early once its
/// query returns true. Scopes nest, and each of them can end the work. parallel_for and
/// parallel_stream carry the scopes of their caller, and one of their Job, to every thread.
class StopScope {
public:
    explicit StopScope(StopQuery requested);
    explicit StopScope(const Job& job);
    ~StopScope();
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

    /// Whether this scope or one around it is to stop.
    bool stop_requested() const;

    /// The innermost scope of this thread; null outside of all.
    static const StopScope* innermost();

    /// A scope of another thread, taken over by this one for as long as this lives.
    class Shared {
    public:
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
