#pragma once

#include "keiko/render/reflection/sample_batch.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// True if two neighbours show different smooth things: a silhouette, a trim border, a crease or
/// the border of a reflection of the body runs between them.
bool differ(const PixelSample& a, const PixelSample& b);

/// True if two places show different smooth things, although they are near enough for the surface's
/// curvature to determine the turn between them. A narrow rounding is no crease.
bool differ_closely(const PixelSample& a, const PixelSample& b);

/// True if two places are equal in the picture: their luminances differ by at most `contrast` of
/// the larger, and they are on one surface if light is still to be added.
bool look_alike(const PixelSample& a, const PixelSample& b, double contrast);

/// State of edges in a pixel before more rays are traced.
enum class Outline : std::uint8_t {
    none,         ///< one ray is enough
    likely,       ///< between its centre and one of its eight neighbours'
    discontinuous ///< the reflection in the pixel is not smooth, or its image is not known to be
                  ///< straight
};

/// Edges of the inner pixels of a grid of camera rays, row by row. The grid is `width` in a row and
/// has a border of one pixel on all sides.
std::vector<Outline> outlines_of(std::span<const PixelSample> samples, int width);

} // namespace keiko
