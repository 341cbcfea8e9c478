#pragma once

#include "keiko/math/vec.h"
#include "keiko/visibility/query/occluders.h"

#include <optional>
#include <span>

namespace keiko {

/// Accuracy of the exchange past occluders.
struct ExchangeOptions {
    double error = 1e-4;    ///< allowed, as a share of the exchange without occluders; above 0
    int most_parts = 20000; ///< triangles that an element is divided into at most
};

/// Exchange area with an estimate of its error.
struct ExchangeArea {
    double value = 0; ///< mm2
    double error = 0; ///< mm2, estimated
};

/// Exchange area of two convex plane polygons as direct_exchange_area() has it, less what occluders
/// hide. The visible part of the second from a point of the first is that of the exact events of
/// all outlines (docs/theory/radiosity.md#past-occluders). Hidden light alone is integrated, over
/// triangles of the first that are halved where they differ most. Elements that are proved to see
/// all or nothing of each other need no quadrature. The polygons themselves may be among the
/// occluders: what lies in the plane of an element hides nothing from it. Throws Cancelled.
ExchangeArea occluded_exchange_area(std::span<const Vec3> first, std::span<const Vec3> second,
                                    const Occluders& occluders,
                                    const ExchangeOptions& options = {});

} // namespace keiko
