#pragma once

#include "keiko/base/job.h"

#include <string>

namespace keiko::cli {

/// Shows progress on stderr: a bar that redraws itself on a terminal, a plain line a stage
/// elsewhere.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    /// Clears the bar.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(const Progress& progress);
    /// Takes the bar off the terminal before other text is printed.
    void clear();

private:
    bool quiet_, terminal_;
    std::string stage_;
    int percent_ = -1;
};

} // namespace keiko::cli
