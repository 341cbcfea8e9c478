#pragma once

#include "keiko/film/film.h"
#include "keiko/raster/mirror_picture.h"

#include <optional>

namespace keiko {

/// Display picture of mirrored lamps: white a lamp, dark the surface, grey where there is none.
Image mirror_image(const MirrorPicture& picture);

/// Display picture of what a mesh shows wrong: the lamps of the surface dimmed, red by the share of
/// the pixel that is off where that is above wrong_coverage, blue where faces differ.
Image wrong_image(const MirrorPicture& truth, const MirrorPicture& mesh);

/// The middle, in pixels, of the square of this side with the largest sum of errors of coverage.
/// Squares are half a side apart; the first of equals by rows. nullopt if nothing is wrong.
std::optional<Vec2> most_wrong_place(const MirrorPicture& truth, const MirrorPicture& mesh,
                                     double side);

/// A camera at the same eye for a square picture of the surroundings of a place of the picture of
/// `camera`. `side`: pixels; `factor`: how many of its pixels an edge of that camera's has.
Camera magnified(const Camera& camera, const Vec2& place, int side, double factor);

} // namespace keiko
