#pragma once

#include "keiko/inspect/openings/free_edges.h"

#include <array>
#include <vector>

namespace keiko {

/// An edge that two faces share by the file, but whose borders are apart.
struct TornEdge {
    std::array<PlacedFace, 2> sides{}; ///< the faces, that of `place` first; one twice where a
                                       ///< closed surface does not meet itself
    double distance = 0; ///< mm, the largest from a border to the nearest place of the other
    double length = 0;   ///< mm along that border, as far as it is farther than the join distance
    Vec3 place{0};       ///< world, mm: the middle between both at that distance
};

/// The shared edges whose borders are more than `join` mm apart where they meet no border at all,
/// for longer than `least` mm. Each pair of faces at an edge has one, in the order of the free
/// edges.
std::vector<TornEdge> torn_edges(const SurfaceModel& model, const BoundaryCurves& curves,
                                 const FreeEdges& edges, double join, double least,
                                 const Job& job = {});

} // namespace keiko
