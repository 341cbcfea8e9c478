#pragma once

#include "keiko/intersect/hit/hit.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko::bench {

/// A surface point that a ray was built to meet.
struct KnownPoint {
    double t = 0;
    Vec3 normal{0}; ///< unit
};

/// Rays of one class, each with a unit direction, and what is true of them.
struct RaySet {
    std::string name{};    ///< primary, mirrored, random, grazing
    bool coherent = false; ///< neighbours run alike: worth a packet
    std::vector<Ray> rays{};
    std::vector<std::optional<Hit>> truth{}; ///< Keiko's first hit, with second derivatives
    std::vector<KnownPoint> known{};         ///< one a ray where rays were built through points
    /// Sine of the angle by which a ray leaves the surface it starts on, one a ray. A peer that
    /// knows no roots to exclude must start that much farther on.
    std::vector<double> leaving_sine{};
};

} // namespace keiko::bench
