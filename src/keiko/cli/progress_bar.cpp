#include "keiko/cli/progress_bar.h"

#include "keiko/base/text.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace keiko::cli {

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
    stage_ = stage;
    percent_ = percent;
    if (terminal_)
        draw();
    else
        tell(new_stage);
}

void ProgressBar::draw() {
    constexpr int width = 32;
    const std::string done(static_cast<std::size_t>(percent_ * width / 100), '#');
    std::fprintf(stderr, "\r\x1b[K%-12s [%-*s] %3d %%", stage_.c_str(), width, done.c_str(),
                 percent_);
}

void ProgressBar::tell(bool new_stage) {
    constexpr std::chrono::seconds rest{10};
    const bool late = Clock::now() - told_ >= rest;
    if (every_stage_ && new_stage)
        std::fprintf(stderr, "keiko: %s\n", stage_.c_str());
    else if (late)
        std::fprintf(stderr, "keiko: %s, %d %%\n", stage_.c_str(), percent_);
    else
        return;
    told_ = Clock::now();
}

void ProgressBar::clear() {
    if (!quiet_ && terminal_ && percent_ >= 0) std::fputs("\r\x1b[K", stderr);
    percent_ = -1;
}

} // namespace keiko::cli
