#pragma once

#include <string_view>

namespace keiko {

/// Result of a comparison with a limit, ordered from good to bad. Undecided: the error bound
/// straddles the limit.
enum class Verdict { pass, undecided, fail };

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

} // namespace keiko
