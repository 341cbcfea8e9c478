#pragma once

#include "keiko/render/reflection/sample_batch.h"

#include <span>

namespace keiko {

/// The direction in the picture, unit, along which the mirror image of a convex part of it is bent
/// most: in which the normal turns most unevenly, as it and its slopes at the part's corners and
/// amid it tell; 0 where it does not turn. All samples have hits with second derivatives.
/// `corners`: px.
Vec2 max_curvature_direction(std::span<const Vec2> corners,
                             std::span<const PixelSample* const> seen, const PixelSample& amid);

} // namespace keiko
