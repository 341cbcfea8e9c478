#pragma once

#include "keiko/raster/triangle_scan.h"

#include <array>
#include <cstddef>
#include <limits>

namespace keiko {

/// Depths of the pixels of a tile of TileGrid: a z-buffer [Catmull1974].
class DepthTile {
public:
    /// Tile of up to 64 x 64 pixels that shows nothing.
    explicit DepthTile(const PixelBox& window) : window_(window) {
        nearness_.fill(-std::numeric_limits<double>::infinity());
    }

    /// The pixels of the tile.
    const PixelBox& window() const { return window_; }
    /// Nearness of what a pixel shows, see ScreenCorner; -infinity: nothing.
    double nearness(int x, int y) const { return nearness_[index(x, y)]; }

    /// Adds a triangle: calls `show`(x, y) for the pixels in which it is nearer than all before.
    template <class Show>
    void add(const ScreenTriangle& triangle, const Show& show) {
        scan_triangle(triangle, window_, [&](int x, int y, double nearness) {
            double& nearest = nearness_[index(x, y)];
            if (!(nearness > nearest)) return;
            nearest = nearness;
            show(x, y);
        });
    }

private:
    static constexpr int side = 64;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>((y - window_.first_y) * side + (x - window_.first_x));
    }

    PixelBox window_;
    std::array<double, static_cast<std::size_t>(side) * side> nearness_;
};

} // namespace keiko
