#pragma once

#include "keiko/render/reflection/eye_view.h"

namespace keiko {

/// A side of a cell whose ends do not show the same, closed in on from both.
struct CrossedSide {
    std::size_t side = 0;
    Vec2 a{0}, b{0}; ///< px
    const EyeSample *at_a = nullptr, *at_b = nullptr;
    enum class State {
        crossed, ///< by one outline
        bent,    ///< by none: the surface turns fast
        tangled  ///< by several
    } state = State::crossed;

    Vec2 middle() const { return (a + b) / 2; }
    double length() const { return (b - a).length(); }
    /// The same, from the end with the lower coordinates to the other.
    CrossedSide upright() const;
    /// Takes over what was found on the upright line.
    void take(const CrossedSide& upright);
    /// `seen` in the middle.
    void halve(const EyeSample& seen);
};

} // namespace keiko
