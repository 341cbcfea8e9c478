#pragma once

#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of the smallest radius of curvature by colour on a logarithmic scale in mm, from red for
/// small radii to blue, with a legend. Radii count whichever way the surface bends.
Image radius_picture(const FilmSight& sight, const AnalysisScale& scale);

/// Picture that is red where the smallest radius of curvature is below `radius` mm and grey
/// elsewhere; borders are averaged over pixels. Where rounding leaves no radius it is dark.
Image below_radius_picture(const FilmSight& sight, double radius);

} // namespace keiko
