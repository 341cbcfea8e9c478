#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <limits>
#include <string_view>

namespace KEIKO_API keiko {

/// Result of a comparison with a limit, ordered from good to bad. Undecided: the error bound
/// straddles the limit.
enum class Verdict {
    pass,      ///< within the limit, by more than the bound
    undecided, ///< the bound straddles the limit
    fail       ///< beyond the limit, by more than the bound
};

/// Verdict on a value known to within `bound`, against the largest one allowed.
constexpr Verdict judge(double value, double bound, double limit) {
    if (value + bound <= limit) return Verdict::pass;
    if (value - bound > limit) return Verdict::fail;
    return Verdict::undecided;
}

/// The verdict on a maximum. Its largest value found is known to within `error`, and values that
/// were not evaluated may be larger by `hidden`. A found value over its limit fails regardless of
/// `hidden`.
constexpr Verdict judge_maximum(double found, double hidden, double error, double limit) {
    if (found + hidden + error <= limit) return Verdict::pass;
    return found - error > limit ? Verdict::fail : Verdict::undecided;
}

/// "pass", "undecided", "fail"
constexpr std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::undecided:
            return "undecided";
        case Verdict::fail:
            return "fail";
    }
    return "";
}

/// The worst value of one quantity along a seam or over a face.
struct MeasuredValue {
    double value = 0;                ///< largest value found
    double bound = 0;                ///< the exact worst lies within this of the value
    double limit = 0;                ///< that it is held to
    Vec3 place{0};                   ///< world, mm
    Verdict verdict = Verdict::pass; ///< by value, bound and limit
    bool at_least = false;           ///< the limit is the smallest value allowed, not the largest
};

/// Ratio of a value to its limit: 1 at the limit, more beyond it. It is infinite for a value of 0
/// or less that is held to a smallest one.
inline double share_of_limit(const MeasuredValue& worst) {
    if (worst.at_least && !(worst.value > 0)) return std::numeric_limits<double>::infinity();
    return worst.at_least ? worst.limit / worst.value : worst.value / worst.limit;
}

/// The worse of two values: by verdict, then by the largest possible value.
inline const MeasuredValue& worse_of(const MeasuredValue& a, const MeasuredValue& b) {
    if (a.verdict != b.verdict) return a.verdict > b.verdict ? a : b;
    return a.value + a.bound >= b.value + b.bound ? a : b;
}

} // namespace keiko
