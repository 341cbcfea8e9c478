#pragma once

#include "keiko/render/eye_view.h"

#include <span>
#include <vector>

namespace keiko {

/// Of the inner pixels of a grid of eye rays, `width` in a row and one pixel off on all sides, row
/// by row: whether an outline runs between the pixel and one of its eight neighbours, or what it
/// mirrors is not smooth, so that one ray a pixel is not enough.
std::vector<bool> outlined_pixels(std::span<const EyeSample> samples, int width);

} // namespace keiko
