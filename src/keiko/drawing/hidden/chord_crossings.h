#pragma once

#include "keiko/drawing/curves/image_projection.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/drawing/hidden/curve_meetings.h"

#include <cstddef>
#include <vector>

namespace keiko {

/// Distances that decide which chords may cross.
struct CrossingLimits {
    double bulge = 0; ///< in the image, of a curve from its chord
    double least = 0; ///< mm, by which the second curve must be nearer to the eye, less both bulges
    double same = 0;  ///< in the image, within which chords coincide and cross nowhere
};

/// The crossings in the image of chord i of a curve with chord j of another one that is nearer to
/// the eye. Each is where shorter chords of the exact curves cross; distances are not set. Chords
/// whose ends lie within their bulge of the other chord's line are halved, twice at most. So both
/// crossings of curves that nearly touch are found.
std::vector<CurveMeeting> chord_crossings(const CurveCourse& a, std::size_t i, const CurveCourse& b,
                                          std::size_t j, const ImageProjection& projection,
                                          const CrossingLimits& limits);

} // namespace keiko
