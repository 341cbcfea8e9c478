#pragma once

#include "keiko/inspect/seams/seam_probe.h"

#include <functional>
#include <optional>

namespace keiko {

/// A quantity of a seam at its worst place.
struct SeamExtreme {
    double value = 0; ///< the largest value found, in the quantity's own unit
    double bound = 0; ///< the true extreme lies within this of the value
    SeamPoint point;  ///< where the quantity has that value
};

/// Quantity at a place of a seam; nullopt if it is not defined there.
using SeamQuantity = std::function<std::optional<double>(const SeamPoint&)>;

/// One quantity and the required accuracy of its maximum, in its own unit.
struct SeamQuestion {
    SeamQuantity quantity; ///< values that are not finite do not count
    double tolerance = 0;  ///< accuracy at which the search ends
};

/// Finds the largest value of each quantity along a seam. Cells are halved, the most promising
/// first, until no cell can hold more than `tolerance` above the best. The peak is then polished on
/// the exact geometry. A cell's upper bound is the largest value at its three points plus their
/// distance from a straight line (four times what a parabola through them could hide). This is an
/// estimate, which needs at least `cells` initial cells that resolve the quantity's variation.
/// Cells end where patches do.
std::vector<std::optional<SeamExtreme>> seam_extremes(const SeamProbe& probe,
                                                      const std::vector<SeamQuestion>& questions,
                                                      int cells = 8);

} // namespace keiko
