#pragma once

#include "keiko/math/bounds.h"
#include "keiko/scene/camera.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// The cells of a picture that a model may be seen in: no ray through any other meets it.
class ScreenBounds {
public:
    /// `boxes`: world, mm; the model is within them.
    ScreenBounds(const Camera& camera, std::span<const Box3> boxes);

    /// Of a pixel of the picture or beside its border.
    bool may_show(int x, int y) const {
        return shown_[static_cast<std::size_t>(cell_at(y)) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(cell_at(x))] != 0;
    }

private:
    static constexpr int cell = 4; ///< pixels a side
    /// The first row and column are beyond the picture's border.
    static int cell_at(int pixel) { return (pixel + cell) / cell; }

    int columns_, rows_;
    std::vector<std::uint8_t> shown_; ///< by row
};

} // namespace keiko
