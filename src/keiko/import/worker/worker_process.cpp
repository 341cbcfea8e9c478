#include "keiko/import/worker/worker_process.h"

#include "keiko/base/error.h"
#include "keiko/base/new_file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

extern char** environ;

namespace keiko {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int first_free_in_child = 4; ///< stdin, stdout, stderr, the answer

[[noreturn]] void no_pipe() {
    throw Error("", "", std::string("cannot open a pipe: ") + std::strerror(errno));
}

/// A pipe whose ends no other child inherits.
struct Pipe {
    Descriptor read, write;

    Pipe() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) no_pipe();
        read.reset(ends[0]);
        const Descriptor low(ends[1]);
        // A program that was started with its stdin or stderr closed gets a pipe at their numbers,
        // which the child then opens anew before it has taken the pipe over.
        write.reset(fcntl(low.number(), F_DUPFD_CLOEXEC, first_free_in_child));
        if (!write.open()) no_pipe();
    }
};

/// A started process in a group of its own; killed and reaped at the end of its scope.
class Child {
public:
    Child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
          int input, int result, int complaints) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        if (input < 0)
            posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        else
            posix_spawn_file_actions_adddup2(&actions, input, 0);
        posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, complaints, 2);
        posix_spawn_file_actions_adddup2(&actions, result, 3);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        // Its own group: an interrupt from the terminal reaches us alone, and killing the group
        // takes along whatever the worker has started.
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setpgroup(&attributes, 0);

        std::vector<std::string> words{program.string()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        argv.reserve(words.size() + 1);
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        const int failure =
            posix_spawn(&pid_, program.c_str(), &actions, &attributes, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
        if (failure != 0) {
            pid_ = 0;
            throw Error(program.string(), "",
                        std::string("cannot be started: ") + std::strerror(failure));
        }
    }
    ~Child() { kill(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Whether it has ended; then `status` is known.
    bool ended() {
        if (pid_ != 0 && wait4(pid_, &status_, WNOHANG, &usage_) == pid_) pid_ = 0;
        return pid_ == 0;
    }
    int status() const { return status_; }
    /// Bytes, once it has ended.
    std::uint64_t peak_memory() const {
        return static_cast<std::uint64_t>(usage_.ru_maxrss) * 1024;
    }
    void kill() {
        if (pid_ == 0) return;
        ::kill(-pid_, SIGKILL);
        waitpid(pid_, &status_, 0);
        pid_ = 0;
    }

private:
    pid_t pid_ = 0;
    int status_ = 0;
    rusage usage_{};
};

/// Reads once what is there; closes the descriptor at its end.
void read_available(Descriptor& from, const std::function<void(std::string_view)>& receive) {
    std::array<char, 1 << 16> buffer;
    const ssize_t count = read(from.number(), buffer.data(), buffer.size());
    if (count > 0)
        receive({buffer.data(), static_cast<std::size_t>(count)});
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
        from.close();
}

/// Waits up to `patience` for either pipe and reads; returns whether anything came.
bool pump(Descriptor& result, Descriptor& complaints, std::chrono::milliseconds patience,
          const std::function<void(std::string_view)>& receive, std::string& stderr_tail) {
    std::array<pollfd, 2> files{{{result.number(), POLLIN, 0}, {complaints.number(), POLLIN, 0}}};
    if (poll(files.data(), files.size(), static_cast<int>(patience.count())) <= 0) return false;
    if (files[0].revents != 0) read_available(result, receive);
    if (files[1].revents != 0)
        read_available(complaints, [&](std::string_view text) {
            constexpr std::size_t kept = 4096;
            stderr_tail.append(text);
            if (stderr_tail.size() > kept) stderr_tail.erase(0, stderr_tail.size() - kept);
        });
    return true;
}

std::string last_line(std::string text) {
    const std::size_t end = text.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) return "";
    text.resize(end + 1);
    const std::size_t begin = text.find_last_of("\r\n");
    return begin == std::string::npos ? text : text.substr(begin + 1);
}

/// An anonymous file in memory with these bytes, to be read from its beginning; none without bytes.
/// Its number is above those that the child opens anew.
Descriptor input_file(std::string_view bytes) {
    if (bytes.empty()) return Descriptor();
    const Descriptor low(memfd_create("keiko-import", MFD_CLOEXEC));
    if (!low.open()) throw_system_error("", "cannot hold the worker's input");
    write_all(low, bytes, "");
    Descriptor file(fcntl(low.number(), F_DUPFD_CLOEXEC, first_free_in_child));
    if (!file.open() || lseek(file.number(), 0, SEEK_SET) != 0)
        throw_system_error("", "cannot hold the worker's input");
    return file;
}

} // namespace

WorkerExit run_worker(const WorkerCall& call, std::chrono::milliseconds timeout,
                      const std::function<void(std::string_view)>& receive, const Job& job) {
    using namespace std::chrono_literals;
    Pipe result, complaints;
    const Descriptor input = input_file(call.input);
    Child child(call.program, call.arguments, input.number(), result.write.number(),
                complaints.write.number());
    result.write.close();
    complaints.write.close();

    WorkerExit exit;
    std::string stderr_tail;
    const auto deadline = Clock::now() + timeout;
    while (!child.ended()) {
        job.check();
        if (Clock::now() > deadline) {
            exit.timed_out = true;
            child.kill();
            break;
        }
        // A worker closes both a moment before it has ended.
        const bool open = result.read.open() || complaints.read.open();
        pump(result.read, complaints.read, open ? 20ms : 1ms, receive, stderr_tail);
    }
    while ((result.read.open() || complaints.read.open()) &&
           pump(result.read, complaints.read, 0ms, receive, stderr_tail)) {
    }
    exit.signal = WIFSIGNALED(child.status()) ? WTERMSIG(child.status()) : 0;
    exit.code = WIFEXITED(child.status()) ? WEXITSTATUS(child.status()) : 0;
    exit.peak_memory = child.peak_memory();
    exit.last_complaint = last_line(stderr_tail);
    return exit;
}

} // namespace keiko
