#pragma once

#include "keiko/base/export.h"

#include <optional>

namespace KEIKO_API keiko {

/// A size that is wanted, and how far it may be from that.
struct NominalSize {
    double nominal = 0;   ///< mm
    double tolerance = 0; ///< mm, either way

    bool operator==(const NominalSize&) const = default;
};

/// Limits of joints (shut lines) between panels that stand apart; what is absent is not judged.
struct JointLimits {
    std::optional<NominalSize> gap{};    ///< KEIKO-JOINT-GAP
    std::optional<NominalSize> flush{};  ///< KEIKO-JOINT-FLUSH, of the second panel over the first
    std::optional<double> parallelism{}; ///< mm, KEIKO-JOINT-PARALLEL: largest gap less smallest
    std::optional<double> radius{};      ///< mm, KEIKO-JOINT-RADIUS: least radius of an edge
    double widest = 15;                  ///< mm: panels farther apart form no joint
    double largest_radius = 12.5;        ///< mm: what bends less across the joint is no edge
    double corner_radius = 100; ///< mm: where one panel's border turns away from the other's
                                ///< in a smaller arc, the joint ends
    double spacing = 10;        ///< mm between sections, at most

    bool operator==(const JointLimits&) const = default;
};

} // namespace keiko
