#pragma once

#include "keiko/inspect/basics/verdict.h"
#include "keiko/math/rgb.h"

#include <optional>

namespace keiko {

/// Colour by which pictures and files of curves show a verdict: green, amber or red, and grey where
/// nothing was judged.
inline Rgb verdict_color(const std::optional<Verdict>& verdict) {
    if (!verdict) return {0.75, 0.75, 0.75};
    if (*verdict == Verdict::fail) return {1, 0.15, 0.1};
    return *verdict == Verdict::pass ? Rgb(0.2, 0.85, 0.25) : Rgb(1, 0.75, 0.1);
}

} // namespace keiko
