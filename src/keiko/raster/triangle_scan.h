#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace keiko {

/// Binary digits of the number of subpixels along the edge of a pixel. Corners are rounded to them,
/// so that the sides of triangles are decided in whole numbers.
constexpr int subpixel_bits = 8;
/// Their number.
constexpr std::int64_t subpixels = std::int64_t{1} << subpixel_bits;

/// Corner of a triangle in the picture.
struct ScreenCorner {
    std::int32_t x = 0, y = 0; ///< subpixels from the picture's upper left
    /// Affine over the picture on a plane, larger where nearer: 1 / depth in perspective, -depth
    /// otherwise.
    double nearness = 0;
};
/// A triangle in the picture.
using ScreenTriangle = std::array<ScreenCorner, 3>;

/// Pixels from the first to the last of either coordinate; none if last < first.
struct PixelBox {
    int first_x = 0, first_y = 0, last_x = -1, last_y = -1; ///< both ends belong to it

    /// True if it has no pixels.
    bool empty() const { return last_x < first_x || last_y < first_y; }
    /// The pixels of both boxes.
    PixelBox within(const PixelBox& other) const {
        return {std::max(first_x, other.first_x), std::max(first_y, other.first_y),
                std::min(last_x, other.last_x), std::min(last_y, other.last_y)};
    }
};

/// Pixels whose centres lie in the box of a triangle.
inline PixelBox pixels_of(const ScreenTriangle& t) {
    // Arithmetic shifts round down, for places left of the picture too.
    constexpr std::int64_t half = subpixels / 2;
    const auto first = [](std::int64_t at) {
        return static_cast<int>((at + half - 1) >> subpixel_bits);
    };
    const auto last = [](std::int64_t at) {
        return static_cast<int>((at - half) >> subpixel_bits);
    };
    return {first(std::min({t[0].x, t[1].x, t[2].x})), first(std::min({t[0].y, t[1].y, t[2].y})),
            last(std::max({t[0].x, t[1].x, t[2].x})), last(std::max({t[0].y, t[1].y, t[2].y}))};
}

/// Twice the area of the triangle a, b, c in square subpixels, positive if it runs clockwise in the
/// picture.
inline std::int64_t doubled_area(const ScreenCorner& a, const ScreenCorner& b,
                                 const ScreenCorner& c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

/// A linear function of the pixel, advanced by increments.
template <class Number>
struct PixelFunction {
    Number start = 0;              ///< at the first pixel of the box
    Number step_x = 0, step_y = 0; ///< from a pixel to the next
};

/// The side of a pixel's centre relative to the edge from `a` to `b` of a clockwise triangle, not
/// negative within. A centre on an edge belongs to the triangle whose top or left edge it is, and
/// so to one of two that share the edge.
inline PixelFunction<std::int64_t> edge_function(const ScreenCorner& a, const ScreenCorner& b,
                                                 const PixelBox& box) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int64_t x = box.first_x * subpixels + subpixels / 2 - a.x;
    const std::int64_t y = box.first_y * subpixels + subpixels / 2 - a.y;
    const bool top_or_left = dy < 0 || (dy == 0 && dx > 0);
    return {dx * y - dy * x - (top_or_left ? 0 : 1), -dy * subpixels, dx * subpixels};
}

/// Nearness of a clockwise triangle of that doubled area.
inline PixelFunction<double> nearness_function(const ScreenTriangle& t, std::int64_t area,
                                               const PixelBox& box) {
    const double b = (t[1].nearness - t[0].nearness) / static_cast<double>(area);
    const double c = (t[2].nearness - t[0].nearness) / static_cast<double>(area);
    const double per_x = b * (t[2].y - t[0].y) - c * (t[1].y - t[0].y);
    const double per_y = c * (t[1].x - t[0].x) - b * (t[2].x - t[0].x);
    const auto x = static_cast<double>(box.first_x * subpixels + subpixels / 2 - t[0].x);
    const auto y = static_cast<double>(box.first_y * subpixels + subpixels / 2 - t[0].y);
    return {t[0].nearness + per_x * x + per_y * y, per_x * subpixels, per_y * subpixels};
}

/// A triangle ready to be scanned by increments [Pineda1988].
struct TriangleFunctions {
    PixelBox box{};                                     ///< of its pixels, within a window
    std::array<PixelFunction<std::int64_t>, 3> edges{}; ///< not negative where it covers a centre
    PixelFunction<double> nearness{};                   ///< of its plane

    /// Functions of a triangle of either sense; its box is empty if it covers no centre.
    TriangleFunctions(ScreenTriangle t, const PixelBox& window) {
        std::int64_t area = doubled_area(t[0], t[1], t[2]);
        if (area < 0) std::swap(t[1], t[2]), area = -area;
        if (area == 0) return;
        box = pixels_of(t).within(window);
        edges = {edge_function(t[0], t[1], box), edge_function(t[1], t[2], box),
                 edge_function(t[2], t[0], box)};
        nearness = nearness_function(t, area, box);
    }
    /// Goes on to the next row.
    void advance() {
        for (PixelFunction<std::int64_t>& edge : edges) edge.start += edge.step_y;
        nearness.start += nearness.step_y;
    }
};

/// Calls `visit`(x, y, nearness) for the pixels of a window whose centres a triangle covers, row by
/// row.
template <class Visit>
void scan_triangle(const ScreenTriangle& triangle, const PixelBox& window, const Visit& visit) {
    TriangleFunctions f(triangle, window);
    for (int y = f.box.first_y; y <= f.box.last_y; ++y, f.advance()) {
        std::int64_t a = f.edges[0].start, b = f.edges[1].start, c = f.edges[2].start;
        double near = f.nearness.start;
        for (int x = f.box.first_x; x <= f.box.last_x; ++x) {
            if ((a | b | c) >= 0) visit(x, y, near);
            a += f.edges[0].step_x, b += f.edges[1].step_x, c += f.edges[2].step_x;
            near += f.nearness.step_x;
        }
    }
}

} // namespace keiko
