#pragma once

#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of `deviations`, which glass_deviations() gives. Colours with a legend are the angle in
/// mrad by which glass turns the line of sight. Lines are a regular grid on a plane far behind the
/// glass, every 0.02 of its distance. All else is grey. Throws Error where no glass is seen.
Image distortion_picture(const FilmSight& sight, const Image& deviations,
                         const AnalysisScale& scale);

} // namespace keiko
