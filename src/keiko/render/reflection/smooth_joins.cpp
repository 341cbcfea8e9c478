#include "keiko/render/reflection/smooth_joins.h"

namespace keiko {

SmoothJoins::SmoothJoins(int width, std::span<const SurfacePlace* const> places)
    : joins_(places.size()) {
    const auto w = static_cast<std::size_t>(width);
    const auto joined = [&](std::size_t a, std::size_t b) {
        return places[b] && continues(*places[a], *places[b]);
    };
    for (std::size_t row = 0; row < places.size(); row += w)
        for (std::size_t i = row; i < row + w; ++i) {
            if (!places[i]) continue;
            joins_[i] = {i + 1 < row + w && joined(i, i + 1),
                         i + w < places.size() && joined(i, i + w)};
        }
}

} // namespace keiko
