#pragma once

#include "keiko/math/rgb.h"

namespace keiko {

/// Shares of the light on a pane, 0 to 1; the pane absorbs the rest.
struct PaneShares {
    Rgb mirrored, passed; ///< back from, and through, the pane
};

/// Shares of a pane of relative index `n` > 0, for light at an angle to its normal of this cosine.
/// It is `thickness` mm thick and absorbs `absorption`, 1/mm, by Beer's law. They are the sums of
/// all reflections inside, without interference (docs/theory/glass.md#panes). Reflectance is the
/// mean of both polarisations at each meeting, as for all surfaces here.
PaneShares pane_shares(double cosine, double n, const Rgb& absorption, double thickness);

} // namespace keiko
