#pragma once

#include "keiko/drawing/curves/image_projection.h"
#include "keiko/drawing/curves/model_curve.h"

#include <optional>

namespace keiko {

/// Parameters at which two curves meet, or come nearest.
struct CurveMeeting {
    double t = 0, u = 0; ///< of the first and of the second
    double distance = 0; ///< mm, between both places in space
};

/// The point of a curve nearest to a place; u is 0. The search begins at the nearest chord.
CurveMeeting nearest_on(const CurveCourse& curve, const Vec3& place);

/// The nearest approach of two curves in space that is found from near places of both.
CurveMeeting approach(const CurveCourse& a, const CurveCourse& b, CurveMeeting from);

/// Places of nearest approach of the chords from a's point i and from b's point j.
CurveMeeting chord_approach(const CurveCourse& a, std::size_t i, const CurveCourse& b,
                            std::size_t j);

/// The crossing of the images of two exact curves that is found by Newton's method from that of
/// their chords; nullopt if it does not converge to one nearby. To about 1e-12 of the image.
std::optional<CurveMeeting> image_crossing(const CurveCourse& a, const CurveCourse& b,
                                           CurveMeeting from, const ImageProjection& projection);

} // namespace keiko
