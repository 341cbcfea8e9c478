#pragma once

#include "keiko/render/crossed_side.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// A square cell of a pixel that may hold an outline, px.
struct OutlineCell {
    std::size_t pixel = 0;
    Vec2 corner{0}; ///< the upper left
    double side = 1;
    int depth = 0;                     ///< 0: the pixel
    const EyeSample* centre = nullptr; ///< where that is known

    /// Around it.
    std::array<Vec2, 4> corners() const {
        return {corner, corner + Vec2(side, 0), corner + Vec2(side, side), corner + Vec2(0, side)};
    }
    std::array<OutlineCell, 4> quarters() const;
};

/// Whether a part of the picture, `size` pixels wide, looks other than the place amid it with a
/// straight image on the lamps' plane tells: the image is bent, or seen at angles so different that
/// the reflectance is not even. `around`: at its corners; `across`: their mean over the part.
bool is_uneven(std::span<const EyeSample* const> around, double across, const EyeSample& amid,
               double size);

/// A cell with what is seen at its corners, around it.
struct SeenCell {
    OutlineCell cell;
    std::array<const EyeSample*, 4> corners{};

    /// The sides, i between the corners i and i + 1, whose ends do not show the same.
    std::vector<std::size_t> crossed_sides() const;
    CrossedSide side(std::size_t i) const;
    /// Whether all corners look like a sample.
    bool looks_like(const EyeSample& sample) const;
    /// Whether the centre tells how all of it looks.
    bool is_told_by(const EyeSample& centre) const;
};

} // namespace keiko
