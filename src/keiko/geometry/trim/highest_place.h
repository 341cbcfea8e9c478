#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"

#include <span>

namespace keiko {

/// Boxes of the control points of each face and each part, part coordinates, mm.
struct HullBoxes {
    std::vector<Box3> faces; ///< as SurfaceModel::faces
    std::vector<Box3> parts; ///< as SurfaceModel::parts
};

/// Limits that end a search for the highest place.
struct SearchLimits {
    double accuracy = 0; ///< mm: no place is higher than the best one by more
    /// Number of cuts of boxes and curves after which the search ends too. Its bound is then less
    /// tight, and still holds.
    std::size_t most_cuts = 200000;
};

/// The height along the unit `direction`, mm, that no place of the material exceeds, to within
/// rounding; some place attains it to within the accuracy. It is -infinity if there is no material.
/// This is branch and bound: the part with the largest bound is cut first. The highest place of a
/// face is inside a patch, on a side or at a corner of one, or on a trim curve. Inside a patch the
/// gradient of the height vanishes there, and on a side the slope along it. So a box where it
/// vanishes nowhere is dropped, and so is a stretch of a curve along which the height only rises or
/// only falls. Throws Cancelled.
double highest_place(const SurfaceModel& model, const HullBoxes& hulls, const Vec3& direction,
                     const SearchLimits& limits, const Job& job);

} // namespace keiko
