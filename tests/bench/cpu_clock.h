#pragma once

#include <ctime>

namespace keiko::bench {

inline double seconds_on(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds of processor time that a piece of work takes of this thread: other programs on the
/// machine disturb it less than a wall clock.
template <class Work>
double thread_seconds(const Work& work) {
    const double begin = seconds_on(CLOCK_THREAD_CPUTIME_ID);
    work();
    return seconds_on(CLOCK_THREAD_CPUTIME_ID) - begin;
}

/// Seconds of processor time that a piece of work takes of all threads. A library that is set to
/// use one thread may use another one than ours.
template <class Work>
double process_seconds(const Work& work) {
    const double begin = seconds_on(CLOCK_PROCESS_CPUTIME_ID);
    work();
    return seconds_on(CLOCK_PROCESS_CPUTIME_ID) - begin;
}

} // namespace keiko::bench
