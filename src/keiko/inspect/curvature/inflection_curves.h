#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"

#include <vector>

namespace KEIKO_API keiko {

/// A parabolic curve on a face: one principal curvature is 0 along it and changes its sign, and the
/// Gaussian curvature with it. On one side the face is convex or concave, on the other a saddle.
struct InflectionCurve {
    bool closed = false;      ///< the last point is the first one again
    bool proved = true;       ///< its course; otherwise likely, not certain
    double length = 0;        ///< mm
    double rate = 0;          ///< 1/mm2: the fastest change of the curvature across the curve
    double deviation = 0;     ///< mm, about the largest distance between curve and chords
    std::vector<Vec3> points; ///< world, mm, on the exact surface
};

/// Options of inflection_curves.
struct InflectionOptions {
    double chord_error = 0.01; ///< mm
    /// 1/mm. A curvature that changes by less all over a face is visually flat, and often flat to
    /// the digits of a file.
    double flat_change = 2e-6;
};

/// The inflection curves of a placed face within its trims, followed over the borders of its
/// patches, the longest first (docs/theory/inspection.md). A jump of the Gaussian curvature over 0
/// at a knot line is none: that is a seam with different curvatures.
std::vector<InflectionCurve> inflection_curves(const SurfaceModel& model, std::uint32_t instance,
                                               std::uint32_t face,
                                               const InflectionOptions& options = {});

} // namespace keiko
