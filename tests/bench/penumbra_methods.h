#pragma once

#include "tests/bench/penumbra_scene.h"

namespace keiko::bench {

/// Part of a tube that is integrated over: its axis, the facing rectangle, or the emitter that
/// pictures use.
enum class Emitter { axis, rectangle, tube };

/// How many strata a lamp is cut into; one shadow ray each.
struct Strata {
    int along = 1, across = 1;
};

/// Illuminance of each receiver from a row, as a share of what the row gives receivers unhidden, on
/// the mean, and what it cost.
struct Shares {
    std::vector<double> values{};
    double seconds = 0; ///< of processor time, all receivers
};

/// By exact intervals of the lamps' axes: the light of a thin lamp in closed form.
Shares by_intervals(const PenumbraScene& scene, const CPlane& row);
/// By exact intervals of sub-axes of the rectangle or the tube, as many as `tolerance` takes.
Shares by_width(const PenumbraScene& scene, const CPlane& row, double tolerance,
                Emitter emitter = Emitter::rectangle);
/// Light-sample ray casting: a ray to a random place of each stratum of each lamp, all rays of a
/// receiver in packets. Of an axis strata lie along it; of a rectangle both ways, which is
/// stratified Monte Carlo sampling of its area.
Shares by_samples(const PenumbraScene& scene, const CPlane& row, Emitter emitter,
                  const Strata& strata);

/// Illuminance that a row gives a receiver unhidden, on the mean.
double mean_unhidden(const PenumbraScene& scene, const CPlane& row, Emitter emitter);

/// RMS of the difference.
double rms(const Shares& a, const Shares& b);

/// Lamps of a row for which single rays contradict the intervals, at some place that is not within
/// 1e-6 of an interval's end.
struct WrongLamps {
    std::size_t lamps = 0, wrong = 0, uncertain = 0, probes = 0;
};
WrongLamps wrong_lamps(const PenumbraScene& scene, const CPlane& row, int probes);

} // namespace keiko::bench
