#include "fixture.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace keiko::fixtures {

void report(const std::string& file, const std::vector<GroundTruth>& truths) {
    for (const GroundTruth& truth : truths) {
        const double error = std::abs(truth.measured - truth.promised);
        std::printf("%-20s %-52s %.9g %s (measured %.9g, off %.1e)\n", file.c_str(),
                    truth.what.c_str(), truth.promised, truth.unit.c_str(), truth.measured, error);
        if (!(error <= truth.tolerance))
            throw std::runtime_error(file + ": " + truth.what + " is not what was promised");
    }
}

} // namespace keiko::fixtures
