#include "keiko/cli/interrupt.h"

#include "keiko/cli/exit_code.h"

#include <unistd.h>

#include <csignal>
#include <ctime>

namespace keiko::cli {
namespace {

sigset_t handled_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

/// Waits for signals so that no code runs in a signal handler.
void wait_for_signals(const std::stop_token& end, std::stop_source& work) {
    const sigset_t set = handled_signals();
    constexpr timespec poll{0, 20'000'000};
    while (!end.stop_requested()) {
        if (sigtimedwait(&set, nullptr, &poll) < 0) continue;
        if (work.stop_requested()) _exit(exit_interrupted);
        work.request_stop();
    }
}

} // namespace

Interrupt::Interrupt() {
    const sigset_t set = handled_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::jthread(
        [work = source_](const std::stop_token& end) mutable { wait_for_signals(end, work); });
}

} // namespace keiko::cli
