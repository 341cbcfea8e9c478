#pragma once

#include <stop_token>
#include <thread>

namespace keiko::cli {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a stop request; a second one ends the process at once.
/// Construct it before any other thread exists: the signals are blocked for all of them.
class Interrupt {
public:
    Interrupt();

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread waiter_;
};

} // namespace keiko::cli
