#pragma once

#include "keiko/inspect/basics/measured_value.h"

namespace keiko {

/// A dent, a bump or waves of a surface.
struct Flaw {
    enum class Kind { dent, bump, waves };
    Kind kind = Kind::dent;
    MeasuredValue depth; ///< mm, how far the surface leaves the form around it
    double width = 0;    ///< mm: between where it bends most the other way; of waves their length
    double window = 0;   ///< mm, of the limit that it is held against
};

} // namespace keiko
