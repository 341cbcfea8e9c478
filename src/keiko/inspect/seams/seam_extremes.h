#pragma once

#include "keiko/inspect/seams/seam_probe.h"

#include <functional>
#include <optional>

namespace keiko {

/// A quantity of a seam at its worst place.
struct SeamExtreme {
    double value = 0;
    double bound = 0; ///< the true extreme lies within this of the value
    SeamPoint point;
};

/// What is asked of each place of a seam; nothing where it is not defined.
using SeamQuantity = std::function<std::optional<double>(const SeamPoint&)>;

/// One quantity and how closely its maximum is wanted, in its own unit.
struct SeamQuestion {
    SeamQuantity quantity;
    double tolerance = 0;
};

/// Finds the largest value of each quantity along a seam: cells are halved, the most promising
/// first, until no cell can hold more than `tolerance` above the best; then the peak is polished
/// on the exact geometry. A cell can hold what its three points show plus how far they are from a
/// straight line (four times what a parabola through them could hide): an estimate, which needs at
/// least `cells` to begin with that show the quantity's ups and downs. Cells end where patches do.
std::vector<std::optional<SeamExtreme>> seam_extremes(const SeamProbe& probe,
                                                      const std::vector<SeamQuestion>& questions,
                                                      int cells = 8);

} // namespace keiko
