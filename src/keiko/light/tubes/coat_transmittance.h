#pragma once

#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/tube_slices.h"

namespace keiko {

/// Share of the light of a lamp's part that enters a coat, 0 to 1. It is the mean over the visible
/// part, weighted by the illuminance of each piece; 0 if all of it lies below the horizon. If
/// `model` is automatic or cylinder it is accurate to 1e-5. Else it takes few half-planes, accurate
/// to 2.3e-3, in the mean to 1e-4. The error is 4e-3 where a short lamp ends at the horizon, and
/// 1e-2 where little of it is left.
double entering_share(const ClearCoat& coat, const TubeSlices& slices,
                      TubeModel model = TubeModel::automatic);

} // namespace keiko
