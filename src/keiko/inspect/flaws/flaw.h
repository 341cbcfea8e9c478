#pragma once

#include "keiko/inspect/basics/verdict.h"

namespace keiko {

/// A dent, a bump or waves of a surface.
struct Flaw {
    enum class Kind { dent, bump, waves };
    Kind kind = Kind::dent;
    MeasuredValue depth; ///< mm, deviation of the surface from the form around it
    double width = 0;    ///< mm: between the largest opposite curvatures; of waves their length
    double window = 0;   ///< mm, of the limit that it is judged by
};

} // namespace keiko
