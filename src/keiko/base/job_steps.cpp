#include "keiko/base/job_steps.h"

#include <algorithm>
#include <utility>

namespace keiko {

Job JobSteps::begin(double weight) {
    step_ = Step{.begin = std::min(1.0, done_ / weight_),
                 .length = weight / weight_,
                 .detail = {},
                 .stage = {}};
    step_.length = std::min(step_.length, 1 - step_.begin);
    done_ += weight;
    return {.progress = {}, .stop = job_.stop, .threads = job_.threads};
}

Job JobSteps::next(double weight, int stages, std::string detail) {
    Job job = begin(weight);
    step_.stages = stages, step_.detail = std::move(detail);
    if (job_.progress) job.progress = [this](const Progress& progress) { tell(progress); };
    return job;
}

Job JobSteps::next_of_steps(double weight) {
    Job job = begin(weight);
    if (job_.progress) job.progress = [this](const Progress& progress) { tell_of_steps(progress); };
    return job;
}

void JobSteps::tell(const Progress& progress) {
    // What is left is shared by the stages still to come; one too many adds nothing.
    const auto room = [&] {
        const int left = std::max(1, step_.stages - step_.begun + 1);
        return (1 - step_.from) / left;
    };
    if (step_.stage != progress.stage || progress.fraction < step_.fraction) {
        if (step_.begun > 0) step_.from += room();
        ++step_.begun;
        step_.stage = progress.stage;
    }
    step_.fraction = progress.fraction;
    const double share = step_.from + room() * progress.fraction;
    const std::string told = step_.detail.empty() ? step_.stage : step_.stage + ' ' + step_.detail;
    job_.report(told, step_.begin + step_.length * share);
}

void JobSteps::tell_of_steps(const Progress& progress) const {
    job_.report(progress.stage, step_.begin + step_.length * progress.fraction);
}

} // namespace keiko
