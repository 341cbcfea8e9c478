#pragma once

#include "keiko/base/export.h"

#include <array>
#include <cstdint>

namespace KEIKO_API keiko {

/// A triangle of a solution on a face of its model.
struct SolvedTriangle {
    std::array<std::uint32_t, 3> corners{}; ///< into the corners of the solution
    std::uint32_t element = 0;              ///< that it belongs to
    std::uint32_t instance = 0, face = 0;   ///< into the arrays of the model

    bool operator==(const SolvedTriangle&) const = default; ///< True if all numbers are equal.
};

} // namespace keiko
