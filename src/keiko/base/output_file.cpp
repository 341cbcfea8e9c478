#include "keiko/base/output_file.h"

#include "keiko/base/error.h"
#include "keiko/base/job.h"
#include "keiko/base/new_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <thread>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds rest{20}; ///< between two queries for a stop

/// Broken pipes are errors of the call while it lives, not signals that end the process.
class NoPipeSignal {
public:
    NoPipeSignal() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~NoPipeSignal() {
        constexpr timespec now{};
        if (sigismember(&before_, SIGPIPE) == 0) sigtimedwait(&pipe_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoPipeSignal(const NoPipeSignal&) = delete;
    NoPipeSignal& operator=(const NoPipeSignal&) = delete;

private:
    sigset_t pipe_, before_;
};

/// Opens a stream whose calls never wait. A pipe that nobody reads yet cannot be opened.
Descriptor open_stream(const fs::path& path) {
    constexpr int flags = O_WRONLY | O_NOCTTY | O_CLOEXEC | O_NONBLOCK;
    for (;;) {
        Descriptor stream(open(path.c_str(), flags));
        if (stream.open()) return stream;
        if (errno != ENXIO || !fs::is_fifo(path)) throw_system_error(path, "cannot write");
        check_stop();
        std::this_thread::sleep_for(rest);
    }
}

void require_stream(const Descriptor& stream, const fs::path& path) {
    struct stat status {};
    if (fstat(stream.number(), &status) != 0 ||
        !(S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode)))
        throw Error(path.string(), "", "is no longer a pipe or a device");
}

void wait_for_room(const Descriptor& stream) {
    pollfd entry{stream.number(), POLLOUT, 0};
    poll(&entry, 1, static_cast<int>(rest.count()));
}

/// Writes bytes into a pipe or a character device as it stands. Waits until someone reads the pipe,
/// and as long as it is full; a stop of the work (StopScope) ends the wait. Throws Error where the
/// path is neither of them by now and when the reader goes away, and Cancelled.
void write_to_stream(const fs::path& path, std::string_view bytes) {
    const Descriptor stream = open_stream(path);
    require_stream(stream, path);
    const NoPipeSignal errors_alone;
    while (!bytes.empty()) {
        check_stop();
        const ssize_t count = write(stream.number(), bytes.data(), bytes.size());
        if (count >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else if (errno == EAGAIN)
            wait_for_room(stream);
        else if (errno != EINTR)
            throw_system_error(path, "cannot write");
    }
}

} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : target_(output_target(path)) {
    if (!target_.stream) file_.emplace(target_.path);
}

void AtomicFile::fill(std::string_view bytes) {
    if (!file_) {
        bytes_ = bytes;
        return;
    }
    file_->write(bytes);
    file_->finish();
}

void AtomicFile::put_in_place() {
    if (!file_) return write_to_stream(target_.path, bytes_);
    file_->put_in_place();
    sync_to_disk(target_.path.parent_path());
}

void sync_to_disk(const fs::path& folder) {
    const Descriptor names(
        open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (names.open()) fsync(names.number());
}

void write_text_file(const fs::path& target, std::string_view text) {
    AtomicFile file(target);
    file.fill(text);
    file.put_in_place();
}

} // namespace keiko
