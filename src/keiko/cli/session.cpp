#include "keiko/cli/session.h"

#include "keiko/api/model.h"
#include "keiko/api/scene.h"
#include "keiko/base/error.h"
#include "keiko/base/job.h"
#include "keiko/base/log.h"
#include "keiko/base/text.h"
#include "keiko/cli/standard_streams.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>

namespace keiko::cli {
namespace {

void tell_usage_error(const CLI::App& app, const CLI::ParseError& error) {
    std::string command = "keiko";
    for (const CLI::App* sub : app.get_subcommands()) command += " " + sub->get_name();
    log_error(std::string(error.what()) + "; see " + command + " --help");
}

/// Reports an unknown command. True if the first argument names no command.
bool tell_unknown_command(const CLI::App& app, int argc, char** argv) {
    const std::string typed = argc > 1 ? argv[1] : "-";
    if (typed.starts_with('-')) return false;
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), typed) != names.end()) return false;
    log_error("there is no command " + in_quotes(typed) + did_you_mean(typed, names) +
              "; see keiko --help");
    return true;
}

/// True if whoever started the program did so without it, as nohup does with SIGHUP.
bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// A blocked signal that is ignored would still come.
sigset_t handled_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    if (!is_ignored(SIGHUP)) sigaddset(&set, SIGHUP);
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

struct OptionName {
    std::string_view field, option;
};

/// Fields whose option has another name.
constexpr OptionName renamed[] = {
    {"columns", "--out"},
    {"hits", "--from"},
    {"views", "--view"},
};

std::string option_of(std::string_view field) {
    for (const OptionName& name : renamed)
        if (name.field == field) return std::string(name.option);
    return "--" + std::string(field);
}

/// One line that describes the error to a user of `command`. The option that sets the field
/// replaces the field's name ("--out: ..."), if the command has such an option.
std::string option_error_line(const FieldError& error, const CLI::App& command) {
    const std::string option = option_of(error.field());
    if (!command.get_option_no_throw(option)) return error.what();
    return Error("", option, error.reason()).what();
}

} // namespace

ProgressBar::ProgressBar(bool quiet, bool every_stage)
    : quiet_(quiet), every_stage_(every_stage), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::show(const Progress& progress) {
    if (quiet_) return;
    const int percent = std::clamp(static_cast<int>(progress.fraction * 100), 0, 100);
    const std::string stage = one_line(progress.stage);
    const bool new_stage = stage_ != stage;
    if (!new_stage && percent == percent_) return;
    if (percent < percent_) began_ = Clock::now(); // of work that comes in several parts
    stage_ = stage;
    percent_ = percent;
    if (terminal_)
        draw();
    else
        tell(new_stage);
}

/// ", about 40 s left"; nothing while that cannot be known.
std::string ProgressBar::time_left() const {
    constexpr std::chrono::duration<double> least{2};
    constexpr int least_percent = 5;
    const std::chrono::duration<double> taken = Clock::now() - began_;
    if (taken < least || percent_ < least_percent || percent_ >= 100) return "";
    const auto left = static_cast<int>(std::ceil(taken.count() * (100 - percent_) / percent_));
    constexpr int minute = 60, in_seconds = 90, step = 5;
    return left > in_seconds
               ? ", about " + std::to_string((left + minute / 2) / minute) + " min left"
           : left > step ? ", about " + std::to_string((left + step - 1) / step * step) + " s left"
                         : ", some seconds left";
}

void ProgressBar::draw() {
    constexpr int width = 32;
    const std::string done(static_cast<std::size_t>(percent_ * width / 100), '#');
    std::fprintf(stderr, "\r\x1b[K%-12s [%-*s] %3d %%%s", stage_.c_str(), width, done.c_str(),
                 percent_, time_left().c_str());
}

void ProgressBar::tell(bool new_stage) {
    constexpr std::chrono::seconds rest{10};
    const bool late = Clock::now() - told_ >= rest;
    if (every_stage_ && new_stage)
        std::fprintf(stderr, "keiko: %s\n", stage_.c_str());
    else if (late)
        std::fprintf(stderr, "keiko: %s, %d %%%s\n", stage_.c_str(), percent_, time_left().c_str());
    else
        return;
    told_ = Clock::now();
}

void ProgressBar::clear() {
    if (!quiet_ && terminal_ && percent_ >= 0) std::fputs("\r\x1b[K", stderr);
    percent_ = -1;
}

CLI::Validator not_empty() {
    return {[](const std::string& text) { return std::string(text.empty() ? "is empty" : ""); },
            ""};
}

CLI::Validator number_between(double low, double high) {
    std::array<char, 64> range{};
    std::snprintf(range.data(), range.size(), "%g to %g", low, high);
    const std::string allowed = range.data();
    const auto reason = [low, high, allowed](const std::string& text) -> std::string {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool whole = !text.empty() && end == text.c_str() + text.size();
        // CLI::Range lets NaN pass.
        if (whole && value >= low && value <= high) return {};
        return "'" + text + "' is not a number from " + allowed;
    };
    return CLI::Validator(reason, allowed);
}

std::string login_name() {
    const passwd* user = getpwuid(geteuid());
    return user ? user->pw_name : std::to_string(geteuid());
}

Interrupt::Interrupt() {
    const sigset_t set = handled_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::jthread(
        [work = source_](const std::stop_token& end) mutable { wait_for_signals(end, work); });
}

void Session::add_command(CLI::App& command, std::function<int(const Job&)> action) {
    command.add_option("--threads", threads_, "threads to use; 0: one a core")
        ->check(number_between(0, 1024))
        ->capture_default_str();
    auto* quiet = command.add_flag("-q,--quiet", quiet_,
                                   "no progress or notes on stderr; results still go to stdout, "
                                   "warnings and errors to stderr");
    command.add_flag("--verbose", verbose_, "tell details on stderr")->excludes(quiet);
    command.callback([this, action = std::move(action)] { action_ = action; });
}

int Session::run(CLI::App& app, int argc, char** argv) {
    if (tell_unknown_command(app, argc, argv)) return exit_error;
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help and --version
        tell_usage_error(app, error);
        return exit_error;
    }
    set_log_level(quiet_ ? LogLevel::quiet : verbose_ ? LogLevel::verbose : LogLevel::normal);
    try {
        return run_action();
    } catch (const Cancelled&) {
        log_error("interrupted");
        return exit_interrupted;
    } catch (const FieldError& error) {
        log_error(option_error_line(error, *app.get_subcommands().back()));
    } catch (const Error& error) {
        log_error(error.what());
    } catch (const std::bad_alloc&) {
        log_error("out of memory");
    } catch (const std::exception& error) {
        log_error(std::string("internal error: ") + error.what());
    }
    return exit_error;
}

int Session::run_action() {
    ProgressBar bar(quiet_, verbose_);
    const Job job{.progress = [&](const Progress& progress) { bar.show(progress); },
                  .stop = interrupt_.token(),
                  .threads = threads_};
    const StopScope scope(job);
    const int exit_code = action_(job);
    errno = 0;
    if (!std::cout.flush()) throw unwritten_output(errno);
    return exit_code;
}

} // namespace keiko::cli
