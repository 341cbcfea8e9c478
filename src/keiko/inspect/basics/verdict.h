#pragma once

#include <string_view>

namespace keiko {

/// Undecided: the error bound straddles the limit. Ordered from good to bad.
enum class Verdict { pass, undecided, fail };

/// Of a value that is known to within `bound`, against the largest one allowed.
constexpr Verdict judge(double value, double bound, double limit) {
    if (value + bound <= limit) return Verdict::pass;
    if (value - bound > limit) return Verdict::fail;
    return Verdict::undecided;
}

/// The verdict on a maximum of which the largest value found is known to within `error`, while what
/// was not evaluated may be larger by `hidden`. A value found over its limit fails, whatever else
/// is hidden.
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
