#pragma once

#include "keiko/render/antialias/edge_cell.h"
#include "keiko/render/shading/edge_samples.h"

#include <span>
#include <vector>

namespace keiko {

/// The sides that outlines cross of each cell in turn, closed in on by halving until the place is
/// known to a sixty-fourth of a pixel or no outline is found there. Cells side by side share what
/// is found.
std::vector<EdgeCrossing> outline_crossings(EdgeSamples& probes, std::span<const SeenCell> cells);

} // namespace keiko
