#pragma once

#include <cmath>
#include <optional>
#include <span>

namespace keiko {

/// Distance from each of some rising levels to the next, if all distances are the same to `same`
/// and larger than that. nullopt for others, and for a single level. Requires one level or more.
inline std::optional<double> even_pitch(std::span<const double> levels, double same) {
    if (levels.size() < 2) return std::nullopt;
    const double pitch =
        (levels.back() - levels.front()) / (static_cast<double>(levels.size()) - 1);
    if (!(pitch > same)) return std::nullopt;
    for (std::size_t i = 1; i < levels.size(); ++i)
        if (!(std::abs(levels[i] - levels[i - 1] - pitch) < same)) return std::nullopt;
    return pitch;
}

} // namespace keiko
