#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/alignment/alignment.h"
#include "keiko/compare/alignment/free_motions.h"

#include <span>

namespace KEIKO_API keiko {

/// The rigid motion that brings measured points onto a surface.
struct PointAlignment {
    Alignment rigid;    ///< of the points; its residual is that of those used
    double used = 0;    ///< share of the sampled points that it was found by, 0 to 1
    FreeMotions free{}; ///< left free by surface and points: along these the points stayed
};

/// Aligns points with the surface that they were measured on: Gauss and Newton's iteration on their
/// exact distances, as align_bodies, with Tukey's biweight [BeatonTukey1974]. Points farther than
/// 4.685 standard deviations hold nothing, nor do those whose closest point lies on a border or
/// farther than a tenth of the surface's size. The start is found by the nearest 70 % of the points
/// [Chetverikov2002]. `options.samples` points are used at most.
///
/// The points stay where they are along a motion that changes their distances by less than a
/// thousandth of its length. The result is the same for any number of threads. Reports stage
/// "align". Throws FieldError of `points` if there are fewer than 12, or so few near the surface,
/// and of `align` for a nominal with too little material; Cancelled.
PointAlignment align_points(std::span<const Vec3> points, const ClosestPointQuery& nominal,
                            const AlignmentOptions& options = {}, const Job& job = {});

} // namespace keiko
