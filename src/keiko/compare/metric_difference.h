#pragma once

#include "keiko/scene/fixture_spec.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A metric that is not what it was.
struct MetricDifference {
    std::string check, name;
    Quantity quantity = Quantity::count;
    /// Nothing: there is no such metric any more, or was none before.
    std::optional<std::variant<double, std::string>> before, after;
    double allowed = 0; ///< how far apart two numbers may be
};

/// What is farther apart than the tolerances, or in one list only; in the order of `after`, then
/// what is gone. Metrics belong together by check and name, which must be unique in a list. A face
/// or seam ("face 3" of "face 3: area") that only its name tells apart from one that is gone is the
/// same: programs that write a part anew name and number as they like.
std::vector<MetricDifference> metric_differences(std::span<const Metric> before,
                                                 std::span<const Metric> after,
                                                 const MetricTolerances& tolerances);

/// "seams: face 1 | face 2: gap: 0.05 -> 0.06 mm, 0.01 more; 1e-05 allowed"
std::string text_of(const MetricDifference& difference);

} // namespace keiko
