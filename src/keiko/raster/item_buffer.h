#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Numbers of what the pixels show at their centres: triangles of a mesh or faces of a model
/// [Weghorst1984]. Shading comes later, for what is seen alone.
struct ItemBuffer {
    int width = 0, height = 0;        ///< pixels
    std::vector<std::uint32_t> shown; ///< numbers, row by row; no_index: nothing

    /// Buffer of a picture that shows nothing.
    ItemBuffer(int w, int h)
        : width(w),
          height(h),
          shown(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), no_index) {}
    /// Number of a pixel, row by row.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    /// Number of what a pixel shows; no_index: nothing.
    std::uint32_t at(int x, int y) const { return shown[index(x, y)]; }
};

} // namespace keiko
