#pragma once

#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/light/tubes/lamp_ends.h"

namespace keiko {

/// Share of a pixel whose image, `footprint` around `centre` (u, v), falls on strips of
/// `strip_width` mm between `ends`, 0 to 1. What projects straight edges to straight ones is cut in
/// the picture itself: the pixel's square by the lines that the strips' edges and chords of their
/// ends are there (homogeneous clipping [BlinnNewell1978]), so that the plane's horizon may run
/// through it. Of strips that overlap, each tube hides those that rays meet later. Not `resolved`:
/// stripes too fine to be told apart, as a grey band.
double end_coverage(const CPlaneFrame& frame, double strip_width, bool resolved,
                    const LampEnds& ends, const Vec2& centre, const Footprint& footprint);

} // namespace keiko
