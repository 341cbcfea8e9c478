#include "keiko/cli/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace keiko::cli {

ProgressBar::ProgressBar(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    clear();
}

void ProgressBar::show(const Progress& progress) {
    if (quiet_) return;
    const int percent = std::clamp(static_cast<int>(progress.fraction * 100), 0, 100);
    const bool new_stage = stage_ != progress.stage;
    if (!new_stage && percent == percent_) return;
    stage_ = progress.stage;
    percent_ = percent;
    if (terminal_) {
        constexpr int width = 32;
        const std::string done(static_cast<std::size_t>(percent * width / 100), '#');
        std::fprintf(stderr, "\r\x1b[K%-12s [%-*s] %3d %%", stage_.c_str(), width, done.c_str(),
                     percent);
    } else if (new_stage) {
        std::fprintf(stderr, "keiko: %s\n", stage_.c_str());
    }
}

void ProgressBar::clear() {
    if (!quiet_ && terminal_ && percent_ >= 0) std::fputs("\r\x1b[K", stderr);
    percent_ = -1;
}

} // namespace keiko::cli
