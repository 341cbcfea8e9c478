#pragma once

#include "keiko/tubes/c_plane_lookup.h"

namespace keiko {

/// The ends of a row's lamps as they look on the plane, mm along u.
struct LampEnds {
    double begin, end;
};

/// Share of a pixel whose image, `footprint` around `centre` (u, v), falls on strips of
/// `strip_width` mm between `ends`, 0 to 1. What projects straight edges to straight ones is cut in
/// the picture itself: the pixel's square by the lines that the ends and the strips' edges are
/// there (homogeneous clipping: Blinn and Newell 1978), so that the plane's horizon may run through
/// it. Not `resolved`: stripes too fine to be told apart, as a grey band.
double end_coverage(const CPlaneFrame& frame, double strip_width, bool resolved,
                    const LampEnds& ends, const Vec2& centre, const Footprint& footprint);

} // namespace keiko
