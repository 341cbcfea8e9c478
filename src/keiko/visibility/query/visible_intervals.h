#pragma once

#include "keiko/math/interval_set.h"

namespace keiko {

/// Visible parts of a segment from one viewpoint.
struct VisibleIntervals {
    IntervalSet intervals; ///< of the segment's parameter, 0 at its begin, 1 at its end
    /// False where events could not be separated: an end may be wrong, or a narrow part missing
    /// there.
    bool certain = true;
};

} // namespace keiko
