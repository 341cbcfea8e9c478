#pragma once

#include "keiko/inspect/overlaps/face_sheet.h"

#include <span>

namespace keiko {

/// True if any two places of a piece of a sheet are proved to be `least` mm apart, or neighbours
/// (docs/theory/structure.md). The way over the surface between neighbours, along the straight line
/// in (s, t), is no longer than `longest` mm. `parts`: those of a box of (s, t) whose size is
/// `extent`. The proof bounds the tangents.
bool near_places_are_neighbours(std::span<const FaceSheet::Part> parts, const Vec2& extent,
                                double least, double longest);

} // namespace keiko
