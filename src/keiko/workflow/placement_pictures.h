#pragma once

#include "keiko/film/film.h"
#include "keiko/workflow/place_scene.h"

namespace keiko {

/// The weight that is reflected to each part of a plane, bright where it is large, with the lamps
/// and their rectangle: u to the right, v up.
Image histogram_picture(const PlacedPlane& plane);

/// Body, C-planes, lamps and cameras from above: x to the right, y up.
Image plan_picture(const Scene& scene, const PlaceResult& result, const Job& job = {});

} // namespace keiko
