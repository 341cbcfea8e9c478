#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/alignment/closest_point_query.h"

#include <limits>
#include <vector>

namespace KEIKO_API keiko {

/// Knobs of measure_deviation.
struct DeviationOptions {
    std::size_t samples = 30000; ///< about as many places, spread evenly; at least 16 a piece
    double certainty = 1e-6;     ///< mm within which a distance must be proved to be certain
    /// mm: places as far away or farther are reported as beyond it, without their distance.
    double reach = std::numeric_limits<double>::infinity();
    double noise = 1e-4; ///< mm: in what direction the other lies is not asked nearer than this
};

/// Place where a body deviates from another.
struct DeviationPlace {
    double value = 0;       ///< mm, or degrees; infinity: nothing of the other is within reach
    Vec3 place{0};          ///< world, mm
    std::uint32_t face = 0; ///< of the model, at the place
};

/// How a face of a body lies to the other.
struct FaceDeviation {
    double area = 0;             ///< mm2, sampled
    DeviationPlace worst;        ///< the largest of its samples and peaks by size, signed
    double root_mean_square = 0; ///< mm, of what is within reach
    double turned = 0;           ///< share of its area with the inside outside
    double beyond = 0;           ///< share of its area from which nothing is within reach
    /// Share of its area that has none of the other above or below: the nearest is aside.
    double beside = 0;
    /// The other's face that most of it lies nearest to; no_index: none within reach.
    std::uint32_t partner = no_index;

    /// Whether the other has no such face.
    bool alone() const { return beyond + beside > 0.5; }
};

/// How far one body lies from another, over its area. Distances are signed: positive outside the
/// other's outward normal.
struct Deviation {
    double area = 0;                       ///< mm2, of the material sampled
    double mean = 0, root_mean_square = 0; ///< mm, of what is within reach
    double lowest = 0, highest = 0;        ///< mm, of what is within reach
    /// mm: what so large a share of the area does not exceed, by size; infinity: beyond reach
    double median = 0, percent_90 = 0, percent_99 = 0, percent_99_9 = 0;
    DeviationPlace worst;             ///< the largest by size, signed, sought beyond the samples
    DeviationPlace worst_normal;      ///< degrees between the normals, where they agree on a side
    DeviationPlace worst_border;      ///< mm from a border of the body to the other's borders
    double claimed_border = 0;        ///< mm, tolerance that the file claims for the edge there
    double reach = 0;                 ///< mm, as requested
    double beyond = 0;                ///< share of the area from which nothing is within reach
    double uncertain_share = 0;       ///< of the area, whose distance is not proved
    double largest_uncertainty = 0;   ///< mm
    std::size_t samples = 0;          ///< number of places measured
    std::vector<FaceDeviation> faces; ///< a face of the body
};

/// Measures how far `body` is from `other` by the nearest points of places spread over it, and
/// climbs from the farthest of them to the worst place. The same for any number of threads. Reports
/// stage "deviation". Throws Cancelled.
Deviation measure_deviation(const ClosestPointQuery& body, const ClosestPointQuery& other,
                            const DeviationOptions& options = {}, const Job& job = {});

/// Whether `body` is everywhere less than `options.reach` mm from `other`. It is sought like the
/// worst place of `measure_deviation`, and the search ends at the first place that is not. False
/// for an infinite reach only where there is no `other`. Reports stage "deviation". Throws
/// Cancelled.
bool lies_within_reach(const ClosestPointQuery& body, const ClosestPointQuery& other,
                       const DeviationOptions& options, const Job& job = {});

} // namespace keiko
