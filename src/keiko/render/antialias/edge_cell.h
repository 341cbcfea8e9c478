#pragma once

#include "keiko/render/antialias/sampled_polygon.h"
#include "keiko/render/reflection/sample_batch.h"

#include <array>
#include <span>

namespace keiko {

/// A side of a cell whose ends show different things, narrowed from both ends.
struct EdgeCrossing {
    std::size_t side = 0;              ///< of the cell, 0 to 3
    Vec2 a{0}, b{0};                   ///< ends of what is left of the side, px
    const PixelSample* at_a = nullptr; ///< sample at a
    const PixelSample* at_b = nullptr; ///< sample at b
    /// State of the search for an edge on the side.
    enum class State {
        crossed,              ///< by one edge
        bent,                 ///< by none: the normal turns fast
        tangled               ///< by several
    } state = State::crossed; ///< as long as no sample in the middle says otherwise

    /// Middle of what is left of the side, px.
    Vec2 middle() const { return (a + b) / 2; }
    /// Length of what is left of the side, px.
    double length() const { return (b - a).length(); }
    /// Copy of the crossing, from the end with the lower coordinates to the other.
    EdgeCrossing upright() const;
    /// Copies the result for the upright line; `side` and the sense stay as they are.
    void take(const EdgeCrossing& upright);
    /// Halves the side; `seen` is the sample in its middle. The half is kept whose ends differ. If
    /// the middle is like both ends the side becomes bent, if it is like neither tangled.
    void halve(const PixelSample& seen);
};

/// A rectangular cell of a pixel that may contain an edge, px.
struct EdgeCell {
    std::size_t pixel = 0;               ///< number of its pixel
    Vec2 corner{0};                      ///< the upper left
    Vec2 size{1};                        ///< width and height
    const PixelSample* centre = nullptr; ///< if known

    /// Corners, around it.
    std::array<Vec2, 4> corners() const {
        return {corner, corner + Vec2(size.x, 0), corner + size, corner + Vec2(0, size.y)};
    }
    /// Area, px2.
    double area() const { return size.x * size.y; }
    /// Its parts on both sides of the middle of its width, `axis` 0, or of its height, 1.
    std::array<EdgeCell, 2> halves(unsigned axis) const;
};

/// A cell with the samples at its corners, around it.
struct SeenCell {
    EdgeCell cell;                               ///< the cell itself
    std::array<const PixelSample*, 4> corners{}; ///< null for a cell whose corners are not sampled
    /// The sides, i between the corners i and i + 1, whose ends show different things.
    InplaceVector<std::size_t, 4> crossed_sides{};

    /// Cell without samples at its corners, and without crossed sides.
    explicit SeenCell(const EdgeCell& unseen) : cell(unseen) {}
    /// Cell with the samples at its corners; a side is crossed if its ends differ_closely().
    SeenCell(const EdgeCell& seen, std::span<const PixelSample* const, 4> around);

    /// Side i, from corner i to the next one, not narrowed yet.
    EdgeCrossing side(std::size_t i) const;
    /// True if all corners equal a sample, to 1 % of a pixel, on a surface that does not turn:
    /// lamps fit into the turn of one that does.
    bool looks_like(const PixelSample& sample) const;
    /// The cell as a polygon with the samples at its corners.
    SampledPolygon part() const;
    /// Axis with the larger variation along the sides that are longer than `finest`, px: the width,
    /// 0, or the height, 1. Of equal ones it is the longer.
    unsigned most_varied_axis(double finest) const;
};

/// Part of a cell on one side of an edge.
struct CutPart {
    SampledPolygon seen; ///< the part, with samples of the cell's corners and the crossings' ends
    Vec2 beside_cut{0};  ///< a place in it by the middle of the cut, px
};

/// A cell that one edge cuts along a straight line.
struct ClippedCell {
    SeenCell seen;                ///< the cell as it was
    std::array<CutPart, 2> parts; ///< from the first crossing to the second, and back to the first

    /// Cell with its crossings by rising side.
    ClippedCell(const SeenCell& cell, const EdgeCrossing& first, const EdgeCrossing& second);

    /// True if the centre, if known, shows the same as its part.
    bool holds_centre() const;
};

} // namespace keiko
