#pragma once

#include "keiko/inspect/basics/verdict.h"

#include <optional>

namespace keiko {

/// A value known to within `bound` that must not be under its limit.
inline MeasuredValue at_least(double value, double bound, double limit, const Vec3& place) {
    MeasuredValue least{value, bound, limit, place, Verdict::undecided, true};
    if (value - bound >= limit) least.verdict = Verdict::pass;
    if (value + bound < limit) least.verdict = Verdict::fail;
    return least;
}

/// The worse of two values that must not be under their limits: by verdict, then the smaller.
inline const MeasuredValue& lesser_of(const MeasuredValue& a, const MeasuredValue& b) {
    if (a.verdict != b.verdict) return a.verdict > b.verdict ? a : b;
    return a.value <= b.value ? a : b;
}

/// Replaces the worst value so far by one that is worse; one that was not found does not count.
inline void keep_worse(std::optional<MeasuredValue>& worst,
                       const std::optional<MeasuredValue>& found) {
    if (found) worst = worst ? worse_of(*worst, *found) : *found;
}

} // namespace keiko
