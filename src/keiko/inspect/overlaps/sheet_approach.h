#pragma once

#include "keiko/inspect/overlaps/face_sheet.h"

namespace keiko {

/// Two places, one of each of two parts of a sheet, that are near each other.
struct SheetApproach {
    Vec2 a{0}, b{0};     ///< parameters of the patches
    double distance = 0; ///< mm
    double angle = 0;    ///< degrees between the tangent planes, 0 to 90; 0 where one has none
    Vec3 middle{0};      ///< mm about the sheet's origin
};

/// Approach of two parts from their middles: by Newton's iteration towards a place that they share,
/// then by the nearest places of each other in turn. A local minimum.
SheetApproach sheet_approach(const FaceSheet::Part& a, const FaceSheet::Part& b);

} // namespace keiko
