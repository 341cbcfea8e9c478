#pragma once

#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/tube_slices.h"

namespace keiko {

/// Share of the light of a lamp's part that enters a coat, 0 to 1: the mean over what is seen of
/// the part, weighted by what each piece of it gives the surface; 0 where all of it lies below the
/// horizon. To 1e-5 where `model` is automatic or cylinder; else in few half-planes, to 2.3e-3, in
/// the mean to 1e-4; 4e-3 where a short lamp ends at the horizon, 1e-2 where little of it is left.
double entering_share(const ClearCoat& coat, const TubeSlices& slices,
                      TubeModel model = TubeModel::automatic);

} // namespace keiko
