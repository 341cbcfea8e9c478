#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/material.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// One of two bodies as its picture shows it. Faces that lie on each other in both bodies have one
/// name, which SharedFaces gives them.
struct OutlineBody {
    const Tracer& tracer;                   ///< of what is visible: the body, then the ground
    const ClosestPointQuery& feet;          ///< of the body alone
    std::span<const Material> paints;       ///< by Hit::face
    std::vector<std::size_t> visible_names; ///< by Hit::face
    std::vector<std::size_t> placed_names;  ///< by face of the PlacedModel
    std::optional<double> ground{};         ///< mm, z of the ground, where there is one
};

/// The distance of a place that one body shows to the faces of the same name of the other, mm;
/// infinity where none is within `reach` mm. A hit that bridges the gap of a seam is moved to the
/// border of its face first: the bridge is no material.
double distance_to_same(const OutlineBody& body, const Hit& hit, const OutlineBody& other,
                        double reach);

} // namespace keiko
