#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace keiko {

/// How far a long function has come.
struct Progress {
    std::string_view stage; ///< what is being done, e.g. "render"
    double fraction = 0;    ///< of this stage, 0 to 1
};

/// The last argument of every long function: where progress goes, when to stop, how many
/// threads to use. A default Job is silent, never stops and uses every core.
struct Job {
    std::function<void(const Progress&)> progress{}; ///< may be empty; calls never overlap
    std::stop_token stop{};
    int threads = 0; ///< 0: as many as there are cores

    void report(std::string_view stage, double fraction) const {
        if (progress) progress({stage, fraction});
    }
    /// Throws Cancelled once a stop was requested.
    void check() const;
};

} // namespace keiko
