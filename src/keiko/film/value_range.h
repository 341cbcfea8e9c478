#pragma once

#include "keiko/base/export.h"

namespace KEIKO_API keiko {

/// Range of values that the colours of a picture span.
struct ValueRange {
    double low = 0;  ///< at which colours are saturated below
    double high = 1; ///< at which they are saturated above, more than `low`
};

} // namespace keiko
