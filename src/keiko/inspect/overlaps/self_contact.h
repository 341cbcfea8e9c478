#pragma once

#include "keiko/inspect/basics/placed_face.h"

#include <cstddef>
#include <optional>

namespace keiko {

/// A place where a face meets itself, or a face that is not shown to keep clear of itself.
struct SelfContact {
    bool found = false;  ///< false: not decided within the bound on work
    double distance = 0; ///< mm between two places of the material; 0 where the face crosses itself
    double way = 0;      ///< mm between them over the surface
    double angle = 0;    ///< degrees between the tangent planes there, 0 to 90
    Vec3 place{0};       ///< world, mm
};

/// Ways over the surface that are more than this times the least distance count: nearer places are
/// neighbours.
constexpr double neighbour_factor = 10;

/// A place at which a placed face comes within `least` mm of itself, farther than that from its
/// borders on one of the two sides; nullopt if it keeps clear. Places count whose way over the
/// surface is longer than `neighbour_factor` times `least`. Pieces of the face are halved until all
/// pairs are proved to be apart or neighbours (docs/theory/structure.md). `most_tests` bounds the
/// work. Throws Cancelled.
std::optional<SelfContact> self_contact(const SurfaceModel& model, const PlacedFace& face,
                                        double least, std::size_t most_tests = 20000);

} // namespace keiko
