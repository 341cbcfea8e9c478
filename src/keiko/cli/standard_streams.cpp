#include "keiko/cli/standard_streams.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <limits>
#include <string>

namespace keiko::cli {
namespace {

/// Waits in short intervals that check for a stop, since signals are handled by their own thread
/// and interrupt no call.
void wait_for(int descriptor, short event, const Job& job) {
    constexpr int milliseconds = 20;
    pollfd entry{descriptor, event, 0};
    do job.check();
    while (poll(&entry, 1, milliseconds) == 0);
}

bool is_file() {
    struct stat status {};
    return fstat(STDOUT_FILENO, &status) == 0 && S_ISREG(status.st_mode);
}

} // namespace

std::size_t StandardInput::read(std::span<char> bytes) const {
    for (;;) {
        wait_for(STDIN_FILENO, POLLIN, job_);
        const ssize_t got = ::read(STDIN_FILENO, bytes.data(), bytes.size());
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR && errno != EAGAIN) throw Error("", "standard input", "cannot read");
    }
}

Error unwritten_output(int code) {
    const std::string reason = code == 0 ? "" : std::string(": ") + std::strerror(code);
    return {"", "standard output", "cannot write" + reason};
}

StandardOutput::StandardOutput(const Job& job)
    : job_(job), most_at_once_(is_file() ? std::numeric_limits<ssize_t>::max() : PIPE_BUF) {
    std::signal(SIGPIPE, SIG_IGN);
}

bool StandardOutput::write(std::string_view text) const {
    while (!text.empty()) {
        wait_for(STDOUT_FILENO, POLLOUT, job_);
        const ssize_t put =
            ::write(STDOUT_FILENO, text.data(), std::min(text.size(), most_at_once_));
        if (put >= 0) {
            text.remove_prefix(static_cast<std::size_t>(put));
            continue;
        }
        if (errno == EPIPE) return false;
        if (errno != EINTR && errno != EAGAIN) throw unwritten_output(errno);
    }
    return true;
}

} // namespace keiko::cli
