#pragma once

#include "keiko/render/lighting/pixel_rectangle.h"
#include "keiko/render/reflection/lit_spot.h"

#include <vector>

namespace keiko {

/// A spot of a pixel that holds an outline.
struct OutlineSpot {
    Pixel pixel;
    const LitSpot* spot;
};

/// Spots of one smooth surface in a row along an outline.
struct OutlineRow {
    std::vector<const LitSpot*> spots;
    std::vector<double> along; ///< where each lies from the first to the last, rising
};

/// Groups of spots of one smooth surface each: two are in one if spots that continue() each other
/// lead from one to the other.
std::vector<std::vector<OutlineSpot>> smooth_surfaces(std::vector<OutlineSpot> spots);

/// All of `spots`, which are of one depth, in rows along straight pieces of outlines: each row of
/// one smooth surface, its pixels apart, at most two off a line and three from one to the next, and
/// sixteen from end to end.
std::vector<OutlineRow> outline_rows(const std::vector<OutlineSpot>& spots);

} // namespace keiko
