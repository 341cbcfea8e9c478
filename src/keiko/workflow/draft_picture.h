#pragma once

#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of the draft angle: blue from the minimum draft up, yellow below it, red where it is
/// negative, with a legend in degrees. The side that is seen counts as outward, so that closed
/// bodies have their own outside and sheets that of the viewer. Borders of the colours are averaged
/// over pixels. Faces that are not the body's are grey.
Image draft_picture(const FilmSight& sight, const AnalysisOptions& options);

} // namespace keiko
