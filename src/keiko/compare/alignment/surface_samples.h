#pragma once

#include "keiko/compare/alignment/closest_point_query.h"

#include <vector>

namespace keiko {

/// A place of a body and how much of it it stands for.
struct SurfaceSample {
    SurfacePoint point; ///< the middle of its cell
    double area = 0;    ///< mm2
    Vec2 cell{0};       ///< extent in parameters of the piece
};

/// Spacing of about `count` places of a body, mm.
double sample_spacing(const ClosestPointQuery& body, std::size_t count);

/// The middles of a piece's cells of `spacing` mm, at least `least` a side, that are material.
std::vector<SurfaceSample> piece_samples(const ClosestPointQuery& body, std::size_t piece,
                                         double spacing, int least);

} // namespace keiko
