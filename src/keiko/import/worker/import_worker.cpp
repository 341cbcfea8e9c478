#include "keiko/base/build_id.h"
#include "keiko/base/error.h"
#include "keiko/base/new_file.h"
#include "keiko/base/text.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/import/worker/worker_answer.h"
#include "keiko/import/worker/worker_libraries.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <sstream>

extern char** environ;

namespace keiko {
namespace {

namespace fs = std::filesystem;

/// How a worker executable ended.
struct WorkerExit {
    bool timed_out = false;
    int signal = 0;                ///< it died of, 0: none
    int code = 0;                  ///< its exit code when it did not die of a signal
    std::uint64_t peak_memory = 0; ///< bytes that it held at most
    std::string last_complaint;    ///< last line it wrote to stderr
};

using Clock = std::chrono::steady_clock;

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

private:
    static constexpr int first_free_in_child = 4; ///< stdin, stdout, stderr, the answer
};

/// A started process in a group of its own; killed and reaped at the end of its scope.
class Child {
public:
    Child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
          int result, int complaints) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
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

/// Runs `program` with `arguments`, without a shell and without forking this process's threads,
/// and hands whatever it writes to file descriptor 3 to `receive`. Its stdout goes nowhere. It is
/// killed, with its children, after `timeout` and when `job` is stopped (then Cancelled is
/// thrown). Throws Error when it cannot be started.
WorkerExit run_worker(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, std::chrono::milliseconds timeout,
                      const std::function<void(std::string_view)>& receive, const Job& job) {
    using namespace std::chrono_literals;
    Pipe result, complaints;
    Child child(program, arguments, result.write.number(), complaints.write.number());
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

std::string seconds(std::chrono::milliseconds duration) {
    std::ostringstream text;
    text << static_cast<double>(duration.count()) / 1000 << " s";
    return text.str();
}

/// Some of OpenCASCADE crashes where it gets no memory. A limit counts address space, and a good
/// part of that never becomes memory.
bool short_of_memory(const WorkerExit& exit, const LoadOptions& options) {
    return options.memory_limit > 0 && exit.peak_memory > options.memory_limit / 4;
}

/// The one line about a worker that did not answer.
std::string failure(const WorkerExit& exit, const LoadOptions& options) {
    if (exit.timed_out) return "the reader did not finish within " + seconds(options.timeout);
    if (exit.signal != 0)
        return std::string("the reader crashed on it: ") + strsignal(exit.signal) +
               (short_of_memory(exit, options) ? ", perhaps for lack of memory" : "");
    return "the reader gave no model (exit code " + std::to_string(exit.code) + ")" +
           (exit.last_complaint.empty() ? "" : ": " + shortened(exit.last_complaint));
}

/// The worker of a program or library in `folder`: beside it, as it is built, or else in libexec of
/// the prefix, whether the folder is bin, lib or lib/TRIPLET. Beside it where there is none.
fs::path installed_worker(const fs::path& folder) {
    const fs::path name = "keiko-import";
    fs::path beside = folder / name;
    std::error_code unknown;
    if (fs::is_regular_file(beside, unknown)) return beside;
    const fs::path prefix = folder.parent_path();
    for (const fs::path& above : {prefix, prefix.parent_path()})
        if (fs::path file = above / "libexec/keiko" / name; fs::is_regular_file(file, unknown))
            return file;
    return beside;
}

} // namespace

fs::path worker_path(const LoadOptions& options) {
    if (!options.worker.empty()) return options.worker;
    if (const char* named = std::getenv("KEIKO_IMPORT"); named && *named) return named;
    return installed_worker(binary_path().parent_path());
}

std::vector<std::string> worker_libraries(const LoadOptions& options) {
    const fs::path worker = worker_path(options);
    std::string answer;
    const auto receive = [&](std::string_view bytes) {
        constexpr std::size_t most = 4096; // whatever program stands there
        answer.append(bytes.substr(0, most - std::min(most, answer.size())));
    };
    const auto patience =
        std::min<std::chrono::milliseconds>(options.timeout, std::chrono::seconds(10));
    const WorkerExit exit = run_worker(worker, {"versions"}, patience, receive, Job{});
    if (exit.timed_out || exit.signal != 0 || exit.code != 0 || answer.empty())
        throw Error(worker.string(), "", "does not state what it reads with");
    std::vector<std::string> libraries;
    std::istringstream lines(answer);
    for (std::string line; std::getline(lines, line);) libraries.push_back(one_line(line));
    return libraries;
}

SurfaceModel import_in_worker(const fs::path& path, ModelFormat format, const LoadOptions& options,
                              const Job& job) {
    const fs::path worker = worker_path(options);
    std::error_code unknown;
    if (!fs::is_regular_file(worker, unknown))
        throw Error(path.string(), "", "cannot be read: no reader at " + worker.string());
    WorkerAnswer answer(path.string(), options.memory_limit, job);
    const WorkerExit exit = run_worker(
        worker,
        {path.string(), std::string(name_of(format)), std::to_string(options.memory_limit),
         std::to_string(job.threads)},
        options.timeout, [&](std::string_view bytes) { answer.receive(bytes); }, job);
    const bool ended_well = !exit.timed_out && exit.signal == 0 && exit.code == 0;
    if (answer.reason().empty() && !(ended_well && answer.has_model()))
        throw Error(path.string(), "", failure(exit, options));
    return answer.model();
}

} // namespace keiko
