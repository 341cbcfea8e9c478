#include "keiko/python/work.h"

namespace keiko::python {

Watch::Watch(const WorkOptions& options) : progress_(options.progress) {
    job_.threads = options.threads, job_.stop = stop_.get_token();
    if (progress_.is_none()) return;
    job_.progress = [this](const Progress& progress) {
        const std::lock_guard lock(mutex_);
        latest_ = {std::string(progress.stage), progress.fraction};
    };
}

void Watch::look() {
    if (raised_) return;
    if (PyErr_CheckSignals() != 0) return stop();
    std::optional<std::pair<std::string, double>> latest;
    {
        const std::lock_guard lock(mutex_);
        latest.swap(latest_);
    }
    if (!latest) return;
    try {
        progress_(latest->first, latest->second);
    } catch (pybind11::error_already_set& raised) {
        raised.restore();
        stop();
    }
}

void Watch::stop() {
    raised_ = std::make_unique<pybind11::error_already_set>();
    stop_.request_stop();
}

void Watch::raise() const {
    if (raised_) throw pybind11::error_already_set(*raised_);
}

} // namespace keiko::python
