#include "keiko/cli/session.h"

#include "keiko/api/model.h"
#include "keiko/api/scene.h"
#include "keiko/base/error.h"
#include "keiko/base/job.h"
#include "keiko/base/log.h"
#include "keiko/base/text.h"
#include "keiko/cli/number_check.h"
#include "keiko/cli/option_names.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>

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

} // namespace

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
    if (!std::cout.flush()) throw Error("", "standard output", "cannot write");
    return exit_code;
}

} // namespace keiko::cli
