#pragma once

#include "keiko/base/job.h"

#include <CLI/App.hpp>

#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <thread>

namespace keiko::cli {

/// Shows progress on stderr. On a terminal it is a bar that redraws itself. Elsewhere it is plain
/// lines: the state every ten seconds, or each stage if requested.
class ProgressBar {
public:
    /// `quiet`: nothing is shown. `every_stage`: lines, not a terminal, state each new stage.
    ProgressBar(bool quiet, bool every_stage);
    /// Clears the bar.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Shows a state, if its stage or its whole percent differs from the last.
    void show(const Progress& progress);
    /// Clears the bar from the terminal before other text is printed.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    std::string time_left() const;
    void draw();
    void tell(bool new_stage);

    bool quiet_, every_stage_, terminal_;
    std::string stage_;
    int percent_ = -1;
    Clock::time_point began_ = Clock::now(), told_ = began_;
};

// The exit codes of every command.
constexpr int exit_pass = 0;          ///< done, and nothing fails
constexpr int exit_findings = 1;      ///< done, and what was tested fails or differs
constexpr int exit_error = 2;         ///< an error, which stderr states
constexpr int exit_interrupted = 130; ///< stopped by SIGINT, SIGTERM or SIGHUP

/// Accepts an option's number from `low` to `high`; NaN and infinity are rejected.
CLI::Validator number_between(double low, double high);
/// Rejects an empty text, the value of an option that is not given.
CLI::Validator not_empty();

/// Name of the user who runs the program, or his number.
std::string login_name();

/// Turns Ctrl-C (SIGINT), SIGTERM and SIGHUP into a stop request; a second one ends the process at
/// once. Construct it before any other thread exists: the signals are blocked for all of them.
class Interrupt {
public:
    /// Blocks the signals for the calling thread and starts the thread that waits for them.
    Interrupt();

    /// Token of the stop request.
    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread waiter_;
};

/// One run of the program: the options every command has, and the job they make.
class Session {
public:
    /// Adds --threads, --quiet and --verbose to a command, and runs `action`, which returns the
    /// exit code, if the command is the requested one.
    void add_command(CLI::App& command, std::function<int(const Job&)> action);

    /// Parses the command line and runs the command. Returns the exit code; every error is reported
    /// in one line on stderr.
    int run(CLI::App& app, int argc, char** argv);
    /// True if --verbose was given.
    bool verbose() const { return verbose_; }

private:
    int run_action();

    Interrupt interrupt_;
    int threads_ = 0;
    bool quiet_ = false, verbose_ = false;
    std::function<int(const Job&)> action_;
};

// Each function adds one command of `keiko` to the app. Its action keeps the options.

/// Adds `keiko accept`.
void add_accept(CLI::App& app, Session& session);
/// Adds `keiko check`.
void add_check(CLI::App& app, Session& session);
/// Adds `keiko compare`.
void add_compare(CLI::App& app, Session& session);
/// Adds `keiko completion`.
void add_completion(CLI::App& app, Session& session);
/// Adds `keiko draw`.
void add_draw(CLI::App& app, Session& session);
/// Adds `keiko illuminance`.
void add_illuminance(CLI::App& app, Session& session);
/// Adds `keiko info`.
void add_info(CLI::App& app, Session& session);
/// Adds `keiko inspect`.
void add_inspect(CLI::App& app, Session& session);
/// Adds `keiko lines`.
void add_lines(CLI::App& app, Session& session);
/// Adds `keiko merge`.
void add_merge(CLI::App& app, Session& session);
/// Adds `keiko mesh-error`.
void add_mesh_error(CLI::App& app, Session& session);
/// Adds `keiko panorama`.
void add_panorama(CLI::App& app, Session& session);
/// Adds `keiko place`.
void add_place(CLI::App& app, Session& session);
/// Adds `keiko radiosity`.
void add_radiosity(CLI::App& app, Session& session);
/// Adds `keiko regress`.
void add_regress(CLI::App& app, Session& session);
/// Adds `keiko render`.
void add_render(CLI::App& app, Session& session);
/// Adds `keiko trace`.
void add_trace(CLI::App& app, Session& session);
/// Adds `keiko view`.
void add_view(CLI::App& app, Session& session);

/// Adds --version, and --verbose for the facts on the build, to the app.
void add_version(CLI::App& app);

} // namespace keiko::cli
