#pragma once

#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of isoparametric lines: of each patch three of constant u in red and three of constant v
/// in blue, at even parameters. Its borders, which are knot lines, are darker and wider; borders of
/// faces are black. Widths are in pixels. Lines that would lie closer than some pixels fade. Needs
/// Aov::uv and Aov::patch.
Image isoparm_picture(const FilmSight& sight);

/// Picture of the patch layout: each Bezier patch in one colour, with dark borders; borders of
/// faces are wider. Needs Aov::patch.
Image patch_picture(const FilmSight& sight);

} // namespace keiko
