#pragma once

#include "keiko/luminance/clear_coat.h"
#include "keiko/tubes/tube_view.h"

namespace keiko {

/// Share of the light of a lamp's part that enters a coat, 0 to 1: the mean over the part's axis,
/// weighted by what each piece of it gives the surface. 0 where the axis lies below the horizon. To
/// about 2e-3; 1.5e-2 where a thick tube is near and its light grazes.
double entering_share(const ClearCoat& coat, const TubeView& view, const VisiblePart& part);

} // namespace keiko
