#pragma once

#include "keiko/light/rig/light_rig.h"
#include "keiko/workflow/film_sight.h"

namespace keiko {

/// Picture of dark and light bands of zebra, isophote or highlight, averaged over pixels. Highlight
/// bands are as wide as the gaps between them; a surface whose normal meets no C-plane of the rig
/// is grey. `camera` is that of `sight`.
Image band_picture(AnalysisMode look, const FilmSight& sight, const Camera& camera,
                   const LightRig& rig);

} // namespace keiko
