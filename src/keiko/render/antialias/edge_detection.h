#pragma once

#include "keiko/render/reflection/sample_batch.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Whether two neighbours do not show the same smooth thing: an outline, a trim border, a crease or
/// the border of a reflection of the body runs between them.
bool differ(const PixelSample& a, const PixelSample& b);

/// True if two places do not show the same smooth thing, though they are so near that the surface's
/// curvature determines how far it turns between them. A narrow rounding is no crease.
bool differ_closely(const PixelSample& a, const PixelSample& b);

/// Whether two places look the same in the picture: luminances that differ by `contrast` of the
/// larger at the most, and one surface where light is still to come.
bool look_alike(const PixelSample& a, const PixelSample& b, double contrast);

/// Knowledge of outlines in a pixel before more rays are sent.
enum class Outline : std::uint8_t {
    none,         ///< one ray is enough
    likely,       ///< between its centre and one of its eight neighbours'
    discontinuous ///< what the pixel mirrors is not smooth, or its image is not known to be
                  ///< straight
};

/// Outlines of the inner pixels of a grid of camera rays, row by row. The grid is `width` in a row
/// and has a border of one pixel on all sides.
std::vector<Outline> outlines_of(std::span<const PixelSample> samples, int width);

} // namespace keiko
