#pragma once

#include "keiko/light/spotlight/beam_spread.h"
#include "keiko/report/markup/json_text.h"

#include <optional>
#include <string>

namespace keiko {

/// Spread in the plane 0 or 90 for a terminal, e.g. "C0-C180: 70 degrees: 60 towards C0, 10 towards
/// C180".
std::string spread_text(PhotometricType type, int plane, const std::optional<BeamSpread>& spread);

/// Full angles {plane_0, plane_90} in degrees; null if an edge is not reached, or all is dark.
Json full_angles_json(const PrincipalSpreads& spreads);

/// Edges {plane_0, plane_90}, each {positive {degrees, reached}, negative {degrees, reached},
/// opposite}, or null if all is dark.
Json edges_json(const PrincipalSpreads& spreads);

} // namespace keiko
