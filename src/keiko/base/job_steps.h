#pragma once

#include "keiko/base/job.h"

#include <string>

namespace keiko {

/// The steps of a long function, one after the other, reported to its caller as one progress that
/// never falls. A step has a weight, its share of the whole work. Keep it for as long as the jobs
/// of its steps.
class JobSteps {
public:
    /// `weight`: the sum of the weights of all steps, in any unit. Refers to `job`.
    JobSteps(const Job& job, double weight) : job_(job), weight_(weight) {}
    JobSteps(const JobSteps&) = delete;
    JobSteps& operator=(const JobSteps&) = delete;

    /// The job of the next step, which ends the one before. Its progress rises through `stages`
    /// equal stages, from 0 to 1 in each. `detail` follows their names, as in "render front".
    Job next(double weight, int stages = 1, std::string detail = {});
    /// The job of a step that has steps of its own: its progress rises from 0 to 1 but once.
    Job next_of_steps(double weight);

private:
    /// The state of the current step.
    struct Step {
        double begin = 0, length = 0; ///< shares of the whole
        int stages = 1;
        std::string detail;
        std::string stage;   ///< the current one; empty before the first
        double from = 0;     ///< share of the step at which the stage began
        double fraction = 0; ///< of the stage
        int begun = 0;       ///< stages, with the current one
    };

    Job begin(double weight);
    void tell(const Progress& progress);
    void tell_of_steps(const Progress& progress) const;

    const Job& job_;
    double weight_;
    double done_ = 0; ///< weight of the steps before
    Step step_;
};

} // namespace keiko
