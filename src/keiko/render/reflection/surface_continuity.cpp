#include "keiko/render/reflection/surface_continuity.h"

namespace keiko {

SurfaceContinuity::SurfaceContinuity(int width, std::span<const SurfacePlace* const> places)
    : joins_(places.size()) {
    const auto w = static_cast<std::size_t>(width);
    const auto joined = [&](std::size_t a, std::size_t b) {
        return places[b] && is_same_surface(*places[a], *places[b]);
    };
    for (std::size_t row = 0; row < places.size(); row += w)
        for (std::size_t i = row; i < row + w; ++i) {
            if (!places[i]) continue;
            joins_[i] = {i + 1 < row + w && joined(i, i + 1),
                         i + w < places.size() && joined(i, i + w)};
        }
}

} // namespace keiko
