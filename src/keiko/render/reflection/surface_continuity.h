#pragma once

#include "keiko/render/reflection/shading_point.h"

#include <span>
#include <vector>

namespace keiko {

/// Which neighbours in a grid of places show one smooth surface.
class SurfaceContinuity {
public:
    SurfaceContinuity() = default;
    /// `places`: row by row, null where nothing is shown.
    SurfaceContinuity(int width, std::span<const SurfacePlace* const> places);

    /// Whether the place of that number and its right or lower neighbour do.
    bool right(std::size_t place) const { return joins_[place].right; }
    bool down(std::size_t place) const { return joins_[place].down; }

private:
    struct Joins {
        bool right = false, down = false;
    };

    std::vector<Joins> joins_;
};

} // namespace keiko
