#pragma once

#include "keiko/light/areas/area_lights.h"

#include "tests/bench/penumbra_methods.h"

#include <vector>

namespace keiko::bench {

/// Panels of 1 cd/m2 that stand side by side behind the body of a scene, as its eye sees it, and
/// face it: parallelograms with the first, second and last corner along their sides.
std::vector<PolygonLight> panels_behind(const PenumbraScene& scene);

/// Mean illuminance of the receivers in lx past no body.
double mean_unhidden(const PenumbraScene& scene, const std::vector<PolygonLight>& panels);

/// Illuminance of each receiver as a share of that mean, by visible lines of the panels, as many as
/// `tolerance` takes.
Shares by_lines(const PenumbraScene& scene, const std::vector<PolygonLight>& panels,
                double tolerance);
/// Illuminance by stratified Monte Carlo sampling: a ray to a random place of each of `side` x
/// `side` strata of each panel, all rays of a receiver in packets.
Shares by_samples(const PenumbraScene& scene, const std::vector<PolygonLight>& panels, int side);

} // namespace keiko::bench
