#include "keiko/cli/session.h"

#include "keiko/base/error.h"
#include "keiko/base/log.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <exception>
#include <new>

namespace keiko::cli {

void Session::add_command(CLI::App& command, std::function<int(const Job&)> action) {
    command.add_option("--threads", threads_, "threads to use; 0: one a core")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    auto* quiet = command.add_flag("-q,--quiet", quiet_, "errors and warnings only");
    command.add_flag("--verbose", verbose_, "tell details on stderr")->excludes(quiet);
    command.callback([this, action = std::move(action)] { action_ = action; });
}

int Session::run(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_pass : exit_error;
    }
    set_log_level(quiet_ ? LogLevel::quiet : verbose_ ? LogLevel::verbose : LogLevel::normal);
    try {
        return run_action();
    } catch (const Cancelled&) {
        log_error("interrupted");
        return exit_interrupted;
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
    ProgressBar bar(quiet_);
    const Job job{.progress = [&](const Progress& progress) { bar.show(progress); },
                  .stop = interrupt_.token(),
                  .threads = threads_};
    return action_(job);
}

} // namespace keiko::cli
