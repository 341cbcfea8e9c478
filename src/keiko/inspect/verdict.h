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
