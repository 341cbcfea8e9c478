#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/shape/deviation.h"
#include "keiko/math/affine.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Deviation of a measured point from the nominal surface.
struct PointDeviation {
    /// mm, positive outside the nominal's outward normal; infinity: nothing of it within reach
    double distance = 0;
    Vec3 closest{0};               ///< of the nominal surface, world, mm; 0 beyond reach
    std::uint32_t face = no_index; ///< of the PlacedModel; no_index beyond reach
    /// Beyond a free border: the nearest place is aside, and says nothing of the surface.
    bool beside = false;
    bool certain = true; ///< the distance is proved

    /// Whether the distance is one of the surface.
    bool is_measured() const { return face != no_index && !beside; }
};

/// Options of point_deviations.
struct ScanOptions {
    double reach = std::numeric_limits<double>::infinity(); ///< mm, beyond which nothing is found
    double certainty = 1e-6; ///< mm within which a distance must be proved to be certain
    double join = 0.5; ///< mm within which a border of another face makes a border no free one
};

/// The deviation of each point, moved by `motion` first, from the exact surface. The same for any
/// number of threads. Reports stage "deviation". Throws Cancelled.
std::vector<PointDeviation> point_deviations(std::span<const Vec3> points, const Affine& motion,
                                             const ClosestPointQuery& nominal,
                                             const ScanOptions& options = {}, const Job& job = {});

/// Numbers of points by their deviation.
struct DeviationHistogram {
    double width = 0;                ///< mm of a bin
    double lowest = 0;               ///< mm, the lower edge of the first
    std::vector<std::size_t> counts; ///< of the bins; the first and the last hold all beyond, too
};

/// Sums over the points that lie nearest to one face.
struct ScannedFace {
    std::size_t points = 0; ///< measured ones
    std::size_t within = 0; ///< of them within the tolerance; 0 without one
    double mean = 0, root_mean_square = 0, lowest = 0, highest = 0; ///< mm
};

/// How far the points of a scan lie from the nominal surface.
struct ScanDeviation {
    std::size_t points = 0;    ///< in the scan
    std::size_t measured = 0;  ///< with a distance of the surface
    std::size_t beyond = 0;    ///< with nothing within reach
    std::size_t beside = 0;    ///< beyond free borders
    std::size_t uncertain = 0; ///< measured, but not proved
    double mean = 0, root_mean_square = 0, standard_deviation = 0; ///< mm, of the measured ones
    DeviationPlace lowest, highest;                                ///< on the nominal surface
    /// mm that so large a share of the measured points does not exceed, by size
    double median = 0, percent_90 = 0, percent_99 = 0, percent_99_9 = 0;
    /// Share of the points, without those beside, whose distance is at most the tolerance: what is
    /// beyond reach is outside of it. nullopt without a tolerance, and without such points.
    std::optional<double> within;
    DeviationHistogram histogram;   ///< of the measured points
    std::vector<ScannedFace> faces; ///< a face of the nominal
};

/// Statistics of the deviations from a nominal of `faces` faces. `tolerance`: mm, either way.
ScanDeviation scan_deviation(std::span<const PointDeviation> points, std::size_t faces,
                             std::optional<double> tolerance);

} // namespace keiko
