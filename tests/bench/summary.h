#pragma once

#include <vector>

namespace keiko::bench {

/// The value below which the share `q` of the values lies, NaN of none.
double quantile(std::vector<double> values, double q);
inline double median(std::vector<double> values) {
    return quantile(static_cast<std::vector<double>&&>(values), 0.5);
}

} // namespace keiko::bench
