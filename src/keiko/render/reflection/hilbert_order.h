#pragma once

#include <cstddef>
#include <vector>

namespace keiko {

/// A place of a grid, numbered row by row.
struct GridPlace {
    int x = 0, y = 0;
    std::size_t number = 0;
};

/// All places of a grid along a Hilbert curve, or several of squares side by side where it is much
/// longer than wide: rays through places that follow each other stay together, which those of a
/// row do not. Valid until the thread asks for a grid of another size.
const std::vector<GridPlace>& hilbert_order(int width, int height);

} // namespace keiko
