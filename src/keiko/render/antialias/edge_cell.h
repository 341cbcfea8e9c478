#pragma once

#include "keiko/render/antialias/sampled_polygon.h"
#include "keiko/render/reflection/sample_batch.h"

#include <array>
#include <span>

namespace keiko {

/// A side of a cell whose ends do not show the same, closed in on from both.
struct EdgeCrossing {
    std::size_t side = 0;
    Vec2 a{0}, b{0}; ///< px
    const PixelSample *at_a = nullptr, *at_b = nullptr;
    enum class State {
        crossed, ///< by one outline
        bent,    ///< by none: the surface turns fast
        tangled  ///< by several
    } state = State::crossed;

    Vec2 middle() const { return (a + b) / 2; }
    double length() const { return (b - a).length(); }
    /// Copy of the crossing, from the end with the lower coordinates to the other.
    EdgeCrossing upright() const;
    /// Takes over what was found on the upright line.
    void take(const EdgeCrossing& upright);
    /// `seen` in the middle.
    void halve(const PixelSample& seen);
};

/// A rectangular cell of a pixel that may hold an outline, px.
struct EdgeCell {
    std::size_t pixel = 0;
    Vec2 corner{0}; ///< the upper left
    Vec2 size{1};
    const PixelSample* centre = nullptr; ///< where that is known

    /// Around it.
    std::array<Vec2, 4> corners() const {
        return {corner, corner + Vec2(size.x, 0), corner + size, corner + Vec2(0, size.y)};
    }
    double area() const { return size.x * size.y; }
    /// Its parts on both sides of the middle of its width, `axis` 0, or of its height, 1.
    std::array<EdgeCell, 2> halves(unsigned axis) const;
};

/// A cell with what is seen at its corners, around it.
struct SeenCell {
    EdgeCell cell;
    std::array<const PixelSample*, 4> corners{};
    /// The sides, i between the corners i and i + 1, whose ends do not show the same.
    InplaceVector<std::size_t, 4> crossed_sides{};

    explicit SeenCell(const EdgeCell& unseen) : cell(unseen) {}
    SeenCell(const EdgeCell& seen, std::span<const PixelSample* const, 4> around);

    EdgeCrossing side(std::size_t i) const;
    /// Whether all corners look like a sample, to 1 % of a pixel, on a surface that does not turn:
    /// lamps fit into where it does.
    bool looks_like(const PixelSample& sample) const;
    SampledPolygon part() const;
    /// Whether more changes over the width, 0, or over the height, 1, of those sides that are
    /// longer than `finest`, px; of the longer where both change alike.
    unsigned most_varied_axis(double finest) const;
};

/// Part of a cell on one side of an outline.
struct CutPart {
    SampledPolygon seen;
    Vec2 beside_cut{0}; ///< a place in it by the middle of the cut, px
};

/// A cell that one outline cuts along a straight line.
struct ClippedCell {
    SeenCell seen;
    std::array<CutPart, 2> parts;

    /// Crossings by rising side.
    ClippedCell(const SeenCell& cell, const EdgeCrossing& first, const EdgeCrossing& second);

    /// Whether the centre, where that is known, shows what its part has to.
    bool holds_centre() const;
};

} // namespace keiko
