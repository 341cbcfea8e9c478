#pragma once

#include "keiko/light/rig/light_rig.h"
#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of dark and light bands of zebra, isophote or highlight, averaged over pixels. Highlight
/// bands of rows are as wide as the gaps between them; places whose normal meets an area light of
/// the rig are light, too. A surface without either is dark, or grey if the rig has no area lights.
/// `camera` is that of `sight`.
Image band_picture(AnalysisMode look, const FilmSight& sight, const Camera& camera,
                   const LightRig& rig);

} // namespace keiko
