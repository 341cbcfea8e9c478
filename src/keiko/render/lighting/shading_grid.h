#pragma once

#include "keiko/render/reflection/shading_point.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace keiko {

/// A place in a grid of camera rays.
struct Pixel {
    int x, y; ///< column and row, from 0 on
};

/// A rectangle of pixels, its last column and row included.
struct Rectangle {
    int x0, y0, x1, y1; ///< first column and row, last column and row

    /// Pixel in the middle, rounded to the first.
    Pixel middle() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
    /// Steps from the first to the last pixel along the longer side; 0 for a single pixel.
    int longest() const { return std::max(x1 - x0, y1 - y0); }
    /// Corners row by row: upper left, upper right, lower left, lower right.
    std::array<Pixel, 4> corners() const { return {{{x0, y0}, {x1, y0}, {x0, y1}, {x1, y1}}}; }
    /// The four parts around the middle, which share its column and row; two if it is one pixel
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
    /// Places at irregular positions: shadows of a row of lamps are stairs, which appear uniform if
    /// places and steps are equally spaced. For narrow rectangles they lie on the border.
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

/// Shading points of one branch on a grid of camera rays, row by row.
class ShadingGrid {
public:
    /// Grid of `points` by rising sample, the first ray of the grid being `first_sample`; kept by
    /// pointer.
    ShadingGrid(int width, int height, std::span<const ShadingPoint> points,
                std::size_t first_sample = 0);
    /// A row of shading points; `along`: the position of each, rising.
    ShadingGrid(std::vector<const ShadingPoint*> row, std::vector<double> along);

    /// Number of places in a row.
    int width() const { return width_; }
    /// Number of rows.
    int height() const { return height_; }
    /// Number of places, also of those without a shading point.
    std::size_t size() const { return spots_.size(); }
    /// Shading point of a place; null if there is none in this branch.
    const ShadingPoint* at(int x, int y) const { return spots_[index(x, y)]; }
    /// True if a place and its right neighbour show one smooth surface.
    bool goes_right(int x, int y) const { return joins_.right(index(x, y)); }
    /// True if a place and its lower neighbour show one smooth surface.
    bool goes_down(int x, int y) const { return joins_.down(index(x, y)); }
    /// True if all of a rectangle, its last row and column included, shows one smooth surface.
    bool is_smooth(int x0, int y0, int x1, int y1) const;

    /// Position of a place in the grid: along a row, or by its column; and its row.
    Vec2 place(const Pixel& p) const { return Vec2(along_[static_cast<std::size_t>(p.x)], p.y); }
    /// Position of a place of a rectangle from its left to its right and from its top to its
    /// bottom, 0 to 1.
    Vec2 share(const Rectangle& r, const Pixel& p) const;
    /// Places besides its middles that test whether a quantity is linear between the corners of a
    /// rectangle; outside rows, Rectangle::odd_places(). In a row they are those farthest from the
    /// line from its first to its last, on either side. At most four in a row remain untested.
    std::vector<Pixel> odd_places(const Rectangle& r) const;

    /// Number of a place, row by row.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

private:
    std::vector<Pixel> odd_places_of_row(const Rectangle& r) const;

    int width_, height_;
    std::vector<const ShadingPoint*> spots_;
    std::vector<double> along_; ///< of the columns
    SurfaceContinuity joins_;
};

/// The shading points of each branch in turn: `visit(shading points of a branch)`.
template <class Visit>
void each_branch(std::span<const ShadingPoint> points, const Visit& visit) {
    while (!points.empty()) {
        std::size_t count = 1;
        while (count < points.size() && points[count].branch == points[0].branch) ++count;
        visit(points.first(count));
        points = points.subspan(count);
    }
}

} // namespace keiko
