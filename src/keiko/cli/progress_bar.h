#pragma once

#include "keiko/base/job.h"

#include <chrono>
#include <string>

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

    void draw();
    void tell(bool new_stage);

    bool quiet_, every_stage_, terminal_;
    std::string stage_;
    int percent_ = -1;
    Clock::time_point told_ = Clock::now();
};

} // namespace keiko::cli
