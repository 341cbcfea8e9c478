#pragma once

#include <cstddef>
#include <vector>

namespace keiko {

/// C(n, 0) .. C(n, n), exact for n up to 50.
inline std::vector<double> binomials(std::size_t n) {
    std::vector<double> row{1};
    for (std::size_t k = 1; k <= n; ++k)
        row.push_back(row.back() * static_cast<double>(n - k + 1) / static_cast<double>(k));
    return row;
}

} // namespace keiko
