#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace keiko {

/// A place in a grid of camera rays.
struct Pixel {
    int x, y;
};

/// A rectangle of pixels, its last column and row with it.
struct Rectangle {
    int x0, y0, x1, y1;

    Pixel middle() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
    int longest() const { return std::max(x1 - x0, y1 - y0); }
    std::array<Pixel, 4> corners() const { return {{{x0, y0}, {x1, y0}, {x0, y1}, {x1, y1}}}; }
    /// The four parts around the middle, which share its column and row; two where it is one pixel
    /// wide or high.
    std::vector<Rectangle> quarters() const {
        const auto [x, y] = middle();
        if (x0 == x1) return {{x0, y0, x1, y}, {x0, y, x1, y1}};
        if (y0 == y1) return {{x0, y0, x, y1}, {x, y0, x1, y1}};
        return {{x0, y0, x, y}, {x, y0, x1, y}, {x0, y, x, y1}, {x, y, x1, y1}};
    }
    /// The other corners of the quarters.
    std::array<Pixel, 5> middles() const {
        const auto [x, y] = middle();
        return {{{x, y}, {x, y0}, {x0, y}, {x1, y}, {x, y1}}};
    }
    /// Places with nothing in common with those, since shadows of a row of lamps are stairs, which
    /// look even where places and steps lie alike. Of narrow rectangles they lie on the border.
    std::vector<Pixel> odd_places() const {
        std::vector<Pixel> odd;
        if (longest() < 3) return odd;
        if (longest() < 6)
            odd = {{x1 - 1, y1 - 1}};
        else
            odd = {{x0 + 3, y0 + 1}, {x1 - 2, y1 - 3}};
        if (longest() >= 12) odd.insert(odd.end(), {{x1 - 5, y0 + 4}, {x0 + 6, y1 - 5}});
        for (Pixel& p : odd) p = {std::clamp(p.x, x0, x1), std::clamp(p.y, y0, y1)};
        return odd;
    }
};

} // namespace keiko
