#pragma once

#include "keiko/base/job.h"
#include "keiko/cli/exit_code.h"
#include "keiko/cli/interrupt.h"
#include "keiko/cli/progress_bar.h"

#include <CLI/App.hpp>

#include <functional>
#include <memory>

namespace keiko::cli {

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

} // namespace keiko::cli
