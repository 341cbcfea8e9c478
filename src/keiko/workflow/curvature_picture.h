#pragma once

#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of a curvature by colour, with a legend in 1/mm or 1/mm2. Signed curvatures are positive
/// in hollows as viewed from the camera. That of sections is `options.sections`, which it needs.
Image curvature_picture(AnalysisMode look, const FilmSight& sight, const AnalysisOptions& options);

/// Range of the picture's colours: by hand or by the percentile, rounded up; from 0 for absolute
/// curvature.
ValueRange curvature_range(AnalysisMode look, const FilmSight& sight,
                           const AnalysisOptions& options);

} // namespace keiko
