#pragma once

#include "keiko/render/reflection/sample_batch.h"

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
    /// The same, from the end with the lower coordinates to the other.
    EdgeCrossing upright() const;
    /// Takes over what was found on the upright line.
    void take(const EdgeCrossing& upright);
    /// `seen` in the middle.
    void halve(const PixelSample& seen);
};

} // namespace keiko
