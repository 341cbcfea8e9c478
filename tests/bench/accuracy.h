#pragma once

#include "tests/bench/contender.h"
#include "tests/bench/place_tolerance.h"

#include <optional>

namespace keiko::bench {

/// Quantiles of the zebra error, px.
struct ZebraError {
    double p50 = 0, p99 = 0, p999 = 0;
};

/// How far a contender's hits are from the truth. docs/benchmarks.md defines each number.
struct Accuracy {
    std::size_t rays = 0;
    std::size_t hits = 0;                  ///< rays that have a hit in truth
    std::size_t missed = 0;                ///< of those, nothing found there
    std::size_t false_hits = 0;            ///< found where in truth is nothing
    double normal_p50 = 0, normal_p99 = 0; ///< arcsec
    double lateral_p99 = 0;                ///< mm, of the reflected ray at 3 m
    std::optional<ZebraError> zebra{};     ///< of rays that come from pixels
};

/// `answers` are those of every `stride`-th ray.
Accuracy judged(const RaySet& rays, const Answers& answers, std::size_t stride,
                const PlaceTolerance& tolerance);

} // namespace keiko::bench
